"""The real robot: finding it, connecting, stopping and calibrating it.

``problem-CODE`` tells a ``RobotProblem`` or a fault of a port; ``remedy-CODE`` what can be done about it.
"""

from donnie_tui.i18n.sentence import Sentence

_PORTS: dict[str, Sentence] = {
    "problem-no-port": Sentence(
        "Nothing is plugged in at {port}.",
        "Não há nada ligado em {port}.",
        "No hay nada conectado en {port}.",
    ),
    "problem-no-permission": Sentence(
        "I may not use {port}.", "Não tenho permissão para {port}.", "No tengo permiso para {port}."
    ),
    "problem-port-busy": Sentence(
        "Another program uses {port}.", "Outro programa usa {port}.", "Otro programa usa {port}."
    ),
    "problem-port-failed": Sentence(
        "I can't use {port}: {reason}.",
        "Não consigo usar {port}: {reason}.",
        "No puedo usar {port}: {reason}.",
    ),
    "problem-no-answer": Sentence(
        "No robot answers at {port}.", "Nenhum robô responde em {port}.", "Ningún robot responde en {port}."
    ),
    "problem-given-up": Sentence(
        "I no longer look for the robot.",
        "Não procuro mais o robô.",
        "Ya no busco el robot.",
    ),
    "problem-no-board": Sentence(
        "I find no robot. Is it plugged in?",
        "Não acho o robô. Está ligado?",
        "No encuentro el robot. ¿Está conectado?",
    ),
    "problem-many-boards": Sentence(
        "There are several: {ports}. Choose one.",
        "Há vários: {ports}. Escolha um.",
        "Hay varios: {ports}. Elige uno.",
    ),
    "remedy-many-boards": Sentence(
        "donnie devices tells which is the robot.",
        "donnie devices diz qual é o robô.",
        "donnie devices dice cuál es el robot.",
    ),
    "remedy-no-permission": Sentence(
        "Join the group {group}: sudo usermod -aG {group} $USER. Then log in again.",
        "Entre no grupo {group}: sudo usermod -aG {group} $USER. Depois entre de novo no sistema.",
        "Entra en el grupo {group}: sudo usermod -aG {group} $USER. Luego vuelve a iniciar sesión.",
    ),
    "remedy-no-group": Sentence(
        "Ask who runs this machine: usually the groups dialout or uucp may use ports.",
        "Peça a quem cuida da máquina: em geral os grupos dialout ou uucp usam portas.",
        "Pregunta a quien cuida la máquina: suelen poder los grupos dialout o uucp.",
        brief=(
            "Ask who runs this machine.",
            "Peça a quem cuida da máquina.",
            "Pregunta a quien cuida la máquina.",
        ),
    ),
    "remedy-port-busy": Sentence(
        "Perhaps another Donnie runs. Leave it first.",
        "Talvez outro Donnie esteja aberto. Saia dele antes.",
        "Quizás haya otro Donnie abierto. Sal de él primero.",
        brief=(
            "Another Donnie may run. Leave it.",
            "Talvez outro Donnie esteja aberto.",
            "Quizás haya otro Donnie abierto.",
        ),
    ),
    "remedy-calibrate": Sentence(
        "To try the conversation without one: --robot double.",
        "Para experimentar a conversa sem ele: --robot double.",
        "Para probar la conversación sin él: --robot double.",
        brief=(
            "To try without one: --robot double.",
            "Para experimentar: --robot double.",
            "Para probar: --robot double.",
        ),
    ),
    "remedy-simulator": Sentence(
        "The simulator needs none: --robot sim.",
        "O simulador não precisa: --robot sim.",
        "El simulador no lo necesita: --robot sim.",
        brief=(
            "The simulator needs none: --robot sim.",
            "O simulador não precisa: --robot sim.",
            "El simulador no: --robot sim.",
        ),
    ),
}

_DEVICES: dict[str, Sentence] = {
    "usage-devices": Sentence(
        "List the serial ports, and what answers there. Nothing moves.",
        "Listar as portas seriais e o que responde nelas. Nada se move.",
        "Listar los puertos serie y lo que responde en ellos. Nada se mueve.",
    ),
    "option-ports": Sentence(
        "ports to ask; otherwise all boards that are plugged in",
        "portas a perguntar; senão, todas as placas ligadas",
        "puertos a preguntar; si no, todas las placas conectadas",
    ),
    "devices-asking": Sentence(
        "I ask {count} {count:port|ports}. A board on USB restarts by that.",
        "Pergunto a {count} {count:porta|portas}. Uma placa USB reinicia com isso.",
        "Pregunto a {count} {count:puerto|puertos}. Una placa USB se reinicia con eso.",
    ),
    "device-robot": Sentence(
        "{port}: robot, original firmware, battery {volts:.1f} volts.",
        "{port}: robô, firmware original, bateria {volts:.1f} volts.",
        "{port}: robot, firmware original, batería {volts:.1f} voltios.",
    ),
    "device-robot-low": Sentence(
        "{port}: robot, original firmware, battery low, {volts:.1f} volts.",
        "{port}: robô, firmware original, bateria fraca, {volts:.1f} volts.",
        "{port}: robot, firmware original, batería baja, {volts:.1f} voltios.",
    ),
    "device-robot-unknown": Sentence(
        "{port}: robot, original firmware, battery unknown.",
        "{port}: robô, firmware original, bateria desconhecida.",
        "{port}: robot, firmware original, batería desconocida.",
    ),
    "device-belt": Sentence("{port}: belt.", "{port}: cinto.", "{port}: cinturón."),
    "device-nothing": Sentence(
        "{port}: nothing answers.", "{port}: nada responde.", "{port}: nada responde."
    ),
    "device-other": Sentence(
        "{port}: no Arduino, not asked.",
        "{port}: não é Arduino, não perguntei.",
        "{port}: no es Arduino, no pregunté.",
    ),
    "devices-none": Sentence(
        "No devices are plugged in. The simulator needs none.",
        "Não há dispositivos ligados. O simulador não precisa.",
        "No hay dispositivos conectados. El simulador no los necesita.",
        brief=(
            "No devices are plugged in.",
            "Não há dispositivos ligados.",
            "No hay dispositivos conectados.",
        ),
    ),
    "devices-use": Sentence(
        "Drive it: donnie --robot serial:{port}",
        "Para usar: donnie --robot serial:{port}",
        "Para usarlo: donnie --robot serial:{port}",
    ),
    "devices-use-belt": Sentence(
        "Feel it: donnie --belt {port}",
        "Para sentir: donnie --belt {port}",
        "Para sentirlo: donnie --belt {port}",
    ),
}

_STOPPING: dict[str, Sentence] = {
    "usage-stop": Sentence(
        "Stop a robot whose program is gone.",
        "Parar um robô cujo programa se foi.",
        "Detener un robot cuyo programa ya no está.",
    ),
    "option-port": Sentence(
        "its port; otherwise the robot of the settings, or the board that is plugged in",
        "sua porta; senão, o robô das configurações, ou a placa ligada",
        "su puerto; si no, el robot de los ajustes, o la placa conectada",
    ),
    "stop-stands": Sentence(
        "The robot stands. Port {port}.",
        "O robô está parado. Porta {port}.",
        "El robot está parado. Puerto {port}.",
    ),
    "stop-unconfirmed": Sentence(
        "I said stop, but nothing answers at {port}. Switch the robot off if it drives.",
        "Mandei parar, mas nada responde em {port}. Desligue o robô se ele andar.",
        "Dije alto, pero nada responde en {port}. Apaga el robot si se mueve.",
    ),
    "stop-in-use": Sentence(
        "I said stop, but another program has {port} and may go on. Stop it there.",
        "Mandei parar, mas outro programa usa {port} e pode continuar. Pare nele.",
        "Dije alto, pero otro programa tiene {port} y puede seguir. Deténlo allí.",
    ),
}

_LINK: dict[str, Sentence] = {
    "link-restarted": Sentence(
        "The robot restarted. It stands.",
        "O robô reiniciou. Está parado.",
        "El robot se reinició. Está parado.",
    ),
    "link-battery-low": Sentence(
        "The robot's battery is low.", "A bateria do robô está fraca.", "La batería del robot está baja."
    ),
    "connect-trying": Sentence(
        "I look for the robot, some seconds.",
        "Procuro o robô, alguns segundos.",
        "Busco el robot, unos segundos.",
    ),
    "connect-waiting": Sentence(
        "I wait for the robot. Ctrl+C gives up.",
        "Espero o robô. Ctrl+C desiste.",
        "Espero al robot. Ctrl+C lo deja.",
    ),
    "connect-simulator": Sentence("I use the simulator.", "Uso o simulador.", "Uso el simulador."),
    "connect-instead": Sentence(
        "I use the simulator instead. CONNECT tries again.",
        "Uso o simulador. CONECTAR tenta de novo.",
        "Uso el simulador. CONECTAR lo intenta de nuevo.",
        brief=(
            "The simulator instead. CONNECT retries.",
            "Uso o simulador. CONECTAR tenta de novo.",
            "El simulador. CONECTAR lo reintenta.",
        ),
    ),
    "connect-busy": Sentence(
        "Not while a program runs.", "Não com um programa rodando.", "No mientras corre un programa."
    ),
    "connect-unknown": Sentence(
        "There is no choice {number}.", "Não há a opção {number}.", "No hay la opción {number}."
    ),
    "connect-choice": Sentence("{number}: {what}.", "{number}: {what}.", "{number}: {what}."),
    "connect-choice-now": Sentence(
        "{number}: {what}, now.", "{number}: {what}, agora.", "{number}: {what}, ahora."
    ),
    "connect-choice-simulator": Sentence("the simulator", "o simulador", "el simulador"),
    "connect-choice-double": Sentence(
        "a simulated board, to try without a robot",
        "uma placa simulada, para testar",
        "una placa simulada, para probar",
        brief=(
            "a simulated board, to try it",
            "uma placa simulada, para testar",
            "una placa simulada, para probar",
        ),
    ),
    "connect-choice-port": Sentence("robot at {port}", "robô em {port}", "robot en {port}"),
    "connect-choice-board": Sentence(
        "robot or belt at {port}", "robô ou cinto em {port}", "robot o cinturón en {port}"
    ),
    "connect-how": Sentence(
        "Type CONNECT and a number.", "Digite CONECTAR e um número.", "Escribe CONECTAR y un número."
    ),
}

_CALIBRATION: dict[str, Sentence] = {
    "usage-calibrate": Sentence(
        "Measure the robot's wheels and axle: it walks and turns, you measure.",
        "Medir as rodas e o eixo do robô: ele anda e gira, você mede.",
        "Medir las ruedas y el eje del robot: él camina y gira, tú mides.",
    ),
    "calibrate-start": Sentence(
        "Put the robot on the floor, with two metres free ahead. I connect.",
        "Ponha o robô no chão, com dois metros livres à frente. Vou conectar.",
        "Pon el robot en el suelo, con dos metros libres delante. Me conecto.",
    ),
    "calibrate-walk": Sentence(
        "Mark where it stands. Enter: it walks {amount} steps.",
        "Marque onde ele está. Enter: ele anda {amount} passos.",
        "Marca dónde está. Enter: camina {amount} pasos.",
    ),
    "calibrate-ask-centimetres": Sentence(
        "How many centimetres did it walk? Enter alone skips this.",
        "Quantos centímetros ele andou? Só Enter pula.",
        "¿Cuántos centímetros caminó? Enter solo lo salta.",
    ),
    "calibrate-turn": Sentence(
        "Mark where it looks. Enter: it turns {amount} degrees to the right.",
        "Marque para onde ele olha. Enter: ele gira {amount} graus à direita.",
        "Marca hacia dónde mira. Enter: gira {amount} grados a la derecha.",
    ),
    "calibrate-ask-degrees": Sentence(
        "How many degrees did it turn in all? A whole turn is 360. Enter alone skips this.",
        "Quantos graus ele girou ao todo? Uma volta são 360. Só Enter pula.",
        "¿Cuántos grados giró en total? Una vuelta son 360. Enter solo lo salta.",
    ),
    "calibrate-number": Sentence("A number, please.", "Um número, por favor.", "Un número, por favor."),
    "stuck-stopped": Sentence(
        "The screen took nothing for a while, so I stopped the robot.",
        "A tela não aceitou nada por um tempo, então parei o robô.",
        "La pantalla no aceptó nada por un rato, así que detuve el robot.",
    ),
    "network-stopped": Sentence(
        "The network hung, so I stopped the robot.",
        "A rede travou, então parei o robô.",
        "La red se cortó, así que detuve el robot.",
        brief=(
            "Network hung: I stopped the robot.",
            "Rede travou: parei o robô.",
            "Red cortada: detuve el robot.",
        ),
    ),
    "suspended-stopped": Sentence(
        "You left with Ctrl+Z, so I stopped the robot.",
        "Você saiu com Ctrl+Z, então parei o robô.",
        "Saliste con Ctrl+Z, así que detuve el robot.",
        brief=("Ctrl+Z: I stopped the robot.", "Ctrl+Z: parei o robô.", "Ctrl+Z: detuve el robot."),
    ),
    "calibrate-cut-short": Sentence(
        "Something stopped it. I leave this out.",
        "Algo o parou. Deixo isso de fora.",
        "Algo lo detuvo. Dejo esto fuera.",
    ),
    "calibrate-absurd": Sentence(
        "That can't be. I leave this out.",
        "Isso não pode ser. Deixo de fora.",
        "Eso no puede ser. Lo dejo fuera.",
    ),
    "calibrate-wheel-radius": Sentence(
        "Wheel radius {millimetres:.2f} millimetres.",
        "Raio da roda {millimetres:.2f} milímetros.",
        "Radio de la rueda {millimetres:.2f} milímetros.",
    ),
    "calibrate-axle-length": Sentence(
        "Axle {millimetres:.2f} millimetres.",
        "Eixo {millimetres:.2f} milímetros.",
        "Eje {millimetres:.2f} milímetros.",
    ),
    "calibrate-kept": Sentence(
        "Kept in the settings.", "Guardado nas configurações.", "Guardado en los ajustes."
    ),
    "calibrate-not-kept": Sentence(
        "That was a simulated board. Nothing is kept.",
        "Foi uma placa simulada. Nada é guardado.",
        "Fue una placa simulada. No se guarda nada.",
    ),
    "calibrate-simulator": Sentence(
        "The simulator has no wheels to measure. donnie calibrate --robot serial measures a robot.",
        "O simulador não tem rodas para medir. donnie calibrate --robot serial mede um robô.",
        "El simulador no tiene ruedas que medir. donnie calibrate --robot serial mide un robot.",
    ),
    "calibrate-enter-alone": Sentence(
        "Enter alone, please. I ask for the number afterwards.",
        "Só Enter, por favor. Pergunto o número depois.",
        "Solo Enter, por favor. Pregunto el número después.",
    ),
    "calibrate-far": Sentence(
        "{number} is far from {expected}. How much was it? The same number again counts.",
        "{number} está longe de {expected}. Quanto foi? O mesmo número de novo vale.",
        "{number} está lejos de {expected}. ¿Cuánto fue? El mismo número otra vez vale.",
    ),
    "calibrate-ended": Sentence(
        "I stop here. Nothing has changed.",
        "Parei aqui. Nada mudou.",
        "Paré aquí. Nada cambió.",
    ),
    "calibrate-nothing": Sentence(
        "Nothing was measured. Nothing has changed.",
        "Nada foi medido. Nada mudou.",
        "No se midió nada. Nada cambió.",
    ),
}

SENTENCES: dict[str, Sentence] = _CALIBRATION | _PORTS | _DEVICES | _STOPPING | _LINK
