"""What ``donnie doctor`` says: what works, what was chosen and why, and the remedy for what does not."""

from donnie_tui.i18n.sentence import Sentence

SENTENCES: dict[str, Sentence] = {
    "usage-doctor": Sentence(
        "Tells what works here, what was chosen and why, and the remedy for what does not work.",
        "Diz o que funciona aqui, o que foi escolhido e por quê, e o remédio para o que não funciona.",
        "Dice qué funciona aquí, qué se eligió y por qué, y el remedio para lo que no funciona.",
    ),
    "doctor-all-well": Sentence("All is well.", "Está tudo bem.", "Todo está bien."),
    "doctor-problems": Sentence(
        "{count} {count:problem|problems}.",
        "{count} {count:problema|problemas}.",
        "{count} {count:problema|problemas}.",
    ),
    "doctor-problem": Sentence("Problem: {text}", "Problema: {text}", "Problema: {text}"),
    "doctor-remedy": Sentence("Remedy: {text}", "Remédio: {text}", "Remedio: {text}"),
    "doctor-version": Sentence(
        "Donnie {version}, Python {python}.",
        "Donnie {version}, Python {python}.",
        "Donnie {version}, Python {python}.",
    ),
    # --- packages
    "doctor-packages": Sentence(
        "All {count} packages are installed.",
        "Os {count} pacotes estão instalados.",
        "Los {count} paquetes están instalados.",
    ),
    "doctor-package-missing": Sentence(
        "the package {name} is missing.", "falta o pacote {name}.", "falta el paquete {name}."
    ),
    "doctor-package-missing-remedy": Sentence(
        "install Donnie again, with pipx or make run.",
        "instale o Donnie de novo, com pipx ou make run.",
        "instala Donnie otra vez, con pipx o make run.",
    ),
    "doctor-package-optional": Sentence(
        "the package {name} is missing, print works.",
        "falta o pacote {name}, o texto funciona.",
        "falta el paquete {name}, el texto funciona.",
    ),
    "doctor-package-optional-remedy": Sentence(
        "install it: pip install {name}.", "instale-o: pip install {name}.", "instálalo: pip install {name}."
    ),
    "doctor-shadowed": Sentence(
        "another package is called {name} too, in {place}.",
        "outro pacote também se chama {name}, em {place}.",
        "otro paquete también se llama {name}, en {place}.",
    ),
    "doctor-shadowed-remedy": Sentence(
        "install Donnie in an environment of its own.",
        "instale o Donnie em um ambiente só dele.",
        "instala Donnie en un entorno propio.",
    ),
    # --- terminal
    "doctor-no-terminal": Sentence(
        "This is no terminal.", "Isto não é um terminal.", "Esto no es una terminal."
    ),
    "doctor-terminal": Sentence(
        "Terminal {name}, {columns} columns, {rows} rows.",
        "Terminal {name}, {columns} colunas, {rows} linhas.",
        "Terminal {name}, {columns} columnas, {rows} filas.",
    ),
    "doctor-terminal-small": Sentence(
        "terminal {name} is small: {columns} columns, {rows} rows.",
        "o terminal {name} é pequeno: {columns} colunas, {rows} linhas.",
        "la terminal {name} es pequeña: {columns} columnas, {rows} filas.",
    ),
    "doctor-terminal-small-remedy": Sentence(
        "enlarge the window, or use donnie --linear.",
        "aumente a janela ou use donnie --linear.",
        "agranda la ventana o usa donnie --linear.",
    ),
    "doctor-encoding": Sentence(
        "the terminal's text is {encoding}, not UTF-8.",
        "o texto do terminal é {encoding}, não UTF-8.",
        "el texto de la terminal es {encoding}, no UTF-8.",
    ),
    "doctor-encoding-remedy": Sentence(
        "set LANG to a UTF-8 locale, such as C.UTF-8.",
        "ponha em LANG um local UTF-8, como C.UTF-8.",
        "pon en LANG una configuración UTF-8, como C.UTF-8.",
    ),
    "doctor-no-colour": Sentence(
        "NO_COLOR is set: no colours.",
        "NO_COLOR está definido: sem cores.",
        "NO_COLOR está puesto: sin colores.",
    ),
    "doctor-mode-visual": Sentence(
        "donnie starts the full screen.", "donnie abre a tela cheia.", "donnie abre la pantalla completa."
    ),
    "doctor-mode-option": Sentence(
        "donnie starts linear, from the option.",
        "donnie abre linear, pela opção.",
        "donnie abre lineal, por la opción.",
    ),
    "doctor-mode-variable": Sentence(
        "donnie starts linear, from a variable.",
        "donnie abre linear, por uma variável.",
        "donnie abre lineal, por una variable.",
    ),
    "doctor-mode-settings": Sentence(
        "donnie starts linear, from the settings.",
        "donnie abre linear, pelos ajustes.",
        "donnie abre lineal, por los ajustes.",
    ),
    "doctor-mode-no-terminal": Sentence(
        "donnie starts linear, without a terminal.",
        "donnie abre linear, sem terminal.",
        "donnie abre lineal, sin terminal.",
    ),
    "doctor-mode-simple-terminal": Sentence(
        "donnie starts linear, the terminal is simple.",
        "donnie abre linear, o terminal é simples.",
        "donnie abre lineal, la terminal es simple.",
    ),
    # --- speech
    "doctor-no-reader": Sentence(
        "No screen reader was found; one may run elsewhere.",
        "Nenhum leitor de tela achado; pode haver um em outro lugar.",
        "No se halló lector de pantalla; puede haber uno en otro lugar.",
    ),
    "doctor-reader": Sentence(
        "Screen reader: {name}.", "Leitor de tela: {name}.", "Lector de pantalla: {name}."
    ),
    "doctor-over-ssh": Sentence("You are here over SSH.", "Você está aqui por SSH.", "Estás aquí por SSH."),
    "doctor-ssip": Sentence(
        "speech-dispatcher answers.", "O speech-dispatcher responde.", "speech-dispatcher responde."
    ),
    "doctor-no-ssip": Sentence(
        "No speech-dispatcher answers.",
        "Nenhum speech-dispatcher responde.",
        "Ningún speech-dispatcher responde.",
    ),
    "doctor-channel-text-asked-for": Sentence(
        "Donnie's answers are in print, as you chose.",
        "As respostas ficam escritas, como você escolheu.",
        "Las respuestas se escriben, como elegiste.",
    ),
    "doctor-channel-text-not-a-terminal": Sentence(
        "Answers are in print: this is no terminal.",
        "As respostas ficam escritas: isto não é um terminal.",
        "Las respuestas se escriben: esto no es una terminal.",
    ),
    "doctor-channel-text-over-ssh": Sentence(
        "Answers are in print: over SSH you would not hear it.",
        "As respostas ficam escritas: por SSH não se ouviria.",
        "Las respuestas se escriben: por SSH no se oiría.",
    ),
    "doctor-channel-text-screen-reader": Sentence(
        "Answers are in print: the screen reader reads them.",
        "As respostas ficam escritas: o leitor de tela as lê.",
        "Las respuestas se escriben: el lector las lee.",
    ),
    "doctor-channel-text-no-voice": Sentence(
        "answers are in print: there is no voice.",
        "as respostas ficam escritas: não há voz.",
        "las respuestas se escriben: no hay voz.",
    ),
    "doctor-channel-text-no-voice-remedy": Sentence(
        "install espeak-ng.", "instale o espeak-ng.", "instala espeak-ng."
    ),
    "doctor-channel-text-no-sound-device": Sentence(
        "answers are in print: there is no sound device.",
        "as respostas ficam escritas: não há dispositivo de som.",
        "las respuestas se escriben: no hay dispositivo de sonido.",
    ),
    "doctor-channel-text-no-sound-device-remedy": Sentence(
        "connect a loudspeaker, or start PipeWire.",
        "ligue um alto-falante ou inicie o PipeWire.",
        "conecta un altavoz o inicia PipeWire.",
    ),
    "doctor-channel-text-no-speech-dispatcher": Sentence(
        "answers are in print: no speech-dispatcher answers.",
        "as respostas ficam escritas: nenhum speech-dispatcher responde.",
        "las respuestas se escriben: ningún speech-dispatcher responde.",
    ),
    "doctor-channel-text-no-speech-dispatcher-remedy": Sentence(
        "start speech-dispatcher, or set SPEECHD_ADDRESS.",
        "inicie o speech-dispatcher ou defina SPEECHD_ADDRESS.",
        "inicia speech-dispatcher o pon SPEECHD_ADDRESS.",
    ),
    "doctor-channel-ssip-asked-for": Sentence(
        "speech-dispatcher speaks, as you chose.",
        "O speech-dispatcher fala, como você escolheu.",
        "speech-dispatcher habla, como elegiste.",
    ),
    "doctor-channel-ssip-speech-dispatcher": Sentence(
        "speech-dispatcher speaks: it is there.",
        "O speech-dispatcher fala: ele está aí.",
        "speech-dispatcher habla: está ahí.",
    ),
    "doctor-channel-ssip-readers-voice": Sentence(
        "speech-dispatcher speaks, behind the screen reader.",
        "O speech-dispatcher fala, depois do leitor de tela.",
        "speech-dispatcher habla, detrás del lector de pantalla.",
    ),
    "doctor-channel-tts-asked-for": Sentence(
        "Donnie's own voice speaks, as you chose.",
        "A voz do Donnie fala, como você escolheu.",
        "La voz de Donnie habla, como elegiste.",
    ),
    "doctor-channel-tts-own-voice": Sentence(
        "Donnie's own voice speaks: nothing else reads.",
        "A voz do Donnie fala: nada mais lê.",
        "La voz de Donnie habla: nada más lee.",
    ),
    "doctor-speak-here": Sentence(
        "SPEAK is heard here, with the answers.",
        "FALAR se ouve aqui, com as respostas.",
        "SPEAK se oye aquí, con las respuestas.",
    ),
    "doctor-speak-robot": Sentence(
        "SPEAK is heard at the robot.", "FALAR se ouve no robô.", "SPEAK se oye en el robot."
    ),
    "doctor-speak-both": Sentence(
        "SPEAK is heard here and at the robot.",
        "FALAR se ouve aqui e no robô.",
        "SPEAK se oye aquí y en el robot.",
    ),
    "doctor-worker-hangs": Sentence(
        "the sound did not answer within {seconds} seconds.",
        "o som não respondeu em {seconds} segundos.",
        "el sonido no respondió en {seconds} segundos.",
    ),
    "doctor-worker-hangs-remedy": Sentence(
        "restart the sound server; print works.",
        "reinicie o servidor de som; o texto funciona.",
        "reinicia el servidor de sonido; el texto funciona.",
    ),
    "doctor-player": Sentence(
        "Sound goes through {name}.", "O som sai por {name}.", "El sonido sale por {name}."
    ),
    "doctor-no-player": Sentence(
        "no sound device works.",
        "nenhum dispositivo de som funciona.",
        "ningún dispositivo de sonido funciona.",
    ),
    "doctor-no-player-remedy": Sentence(
        "everything is in print; connect a loudspeaker.",
        "tudo fica escrito; ligue um alto-falante.",
        "todo se escribe; conecta un altavoz.",
    ),
    "doctor-no-voice": Sentence("no voice works.", "nenhuma voz funciona.", "ninguna voz funciona."),
    "doctor-no-voice-remedy": Sentence(
        "install espeak-ng, or pip install espeakng-loader.",
        "instale espeak-ng ou pip install espeakng-loader.",
        "instala espeak-ng o pip install espeakng-loader.",
    ),
    "doctor-voice-en": Sentence(
        "There is an English voice.", "Há uma voz em inglês.", "Hay una voz en inglés."
    ),
    "doctor-voice-pt": Sentence(
        "There is a Portuguese voice.", "Há uma voz em português.", "Hay una voz en portugués."
    ),
    "doctor-voice-es": Sentence(
        "There is a Spanish voice.", "Há uma voz em espanhol.", "Hay una voz en español."
    ),
    "doctor-voice-en-missing": Sentence(
        "no English voice.", "não há voz em inglês.", "no hay voz en inglés."
    ),
    "doctor-voice-en-missing-remedy": Sentence(
        "install espeak-ng's voices.", "instale as vozes do espeak-ng.", "instala las voces de espeak-ng."
    ),
    "doctor-voice-pt-missing": Sentence(
        "no Portuguese voice.", "não há voz em português.", "no hay voz en portugués."
    ),
    "doctor-voice-pt-missing-remedy": Sentence(
        "install espeak-ng's voices.", "instale as vozes do espeak-ng.", "instala las voces de espeak-ng."
    ),
    "doctor-voice-es-missing": Sentence(
        "no Spanish voice.", "não há voz em espanhol.", "no hay voz en español."
    ),
    "doctor-voice-es-missing-remedy": Sentence(
        "install espeak-ng's voices.", "instale as vozes do espeak-ng.", "instala las voces de espeak-ng."
    ),
    "doctor-cues": Sentence("Sound cues are on.", "Os sons estão ligados.", "Los sonidos están activos."),
    "doctor-no-cues": Sentence(
        "Sound cues are off.", "Os sons estão desligados.", "Los sonidos están apagados."
    ),
    "doctor-own-sounds": Sentence(
        "{count} {count:sound|sounds} of your own: {names}.",
        "{count} {count:som seu|sons seus}: {names}.",
        "{count} {count:sonido tuyo|sonidos tuyos}: {names}.",
    ),
    "doctor-own-sound-broken": Sentence(
        "your sound {name} can't be read.",
        "seu som {name} não pode ser lido.",
        "tu sonido {name} no se puede leer.",
    ),
    "doctor-own-sound-broken-remedy": Sentence(
        "save it as a 16-bit WAV file.", "salve-o como WAV de 16 bits.", "guárdalo como WAV de 16 bits."
    ),
    "doctor-own-sound-unknown": Sentence(
        "your sound {name} is called like no cue.",
        "seu som {name} não tem nome de sinal.",
        "tu sonido {name} no tiene nombre de señal.",
    ),
    "doctor-own-sound-unknown-remedy": Sentence(
        "CUES in the linear mode lists the names.",
        "SINAIS no modo linear lista os nomes.",
        "SEÑALES en el modo lineal lista los nombres.",
    ),
    # --- serial ports
    "doctor-port": Sentence(
        "Serial port {port} can be used.", "A porta {port} pode ser usada.", "El puerto {port} se puede usar."
    ),
    "doctor-port-board": Sentence(
        "Port {port} has a board like Donnie's.",
        "A porta {port} tem uma placa como a do Donnie.",
        "El puerto {port} tiene una placa como la de Donnie.",
    ),
    "doctor-port-forbidden": Sentence(
        "you may not use port {port}.",
        "você não pode usar a porta {port}.",
        "no puedes usar el puerto {port}.",
    ),
    "doctor-port-forbidden-remedy": Sentence(
        "sudo usermod -aG {group} $USER, then log in again.",
        "sudo usermod -aG {group} $USER, e entre de novo.",
        "sudo usermod -aG {group} $USER, y entra otra vez.",
    ),
    "doctor-port-closed": Sentence(
        "you may not use port {port}.",
        "você não pode usar a porta {port}.",
        "no puedes usar el puerto {port}.",
    ),
    "doctor-port-closed-remedy": Sentence(
        "ask who runs this machine; usually the groups dialout or uucp may.",
        "peça a quem cuida da máquina; em geral os grupos dialout ou uucp podem.",
        "pregunta a quien cuida la máquina; suelen poder los grupos dialout o uucp.",
    ),
    "doctor-nothing-there": Sentence(
        "nothing is plugged in at {port}, where {setting} looks.",
        "nada está conectado em {port}, onde {setting} procura.",
        "no hay nada conectado en {port}, donde busca {setting}.",
    ),
    "doctor-nothing-there-remedy": Sentence(
        "plug it in, or see donnie devices for what is there.",
        "conecte-o, ou veja em donnie devices o que há.",
        "conéctalo, o mira en donnie devices lo que hay.",
    ),
    "doctor-no-ports": Sentence(
        "No serial port is plugged in.", "Nenhuma porta serial conectada.", "Ningún puerto serie conectado."
    ),
    "doctor-reset": Sentence(
        "GPIO{pin} can restart the robot's board.",
        "GPIO{pin} pode reiniciar a placa do robô.",
        "GPIO{pin} puede reiniciar la placa del robot.",
    ),
    "doctor-reset-package": Sentence(
        "GPIO{pin} can't restart the robot's board: the package gpiod is missing.",
        "GPIO{pin} não pode reiniciar a placa do robô: falta o pacote gpiod.",
        "GPIO{pin} no puede reiniciar la placa del robot: falta el paquete gpiod.",
    ),
    "doctor-reset-package-remedy": Sentence(
        'pip install "donnie-tui[pi]".', 'pip install "donnie-tui[pi]".', 'pip install "donnie-tui[pi]".'
    ),
    "doctor-reset-forbidden": Sentence(
        "you may not use GPIO{pin}, which restarts the robot's board.",
        "você não pode usar GPIO{pin}, que reinicia a placa do robô.",
        "no puedes usar GPIO{pin}, que reinicia la placa del robot.",
    ),
    "doctor-reset-forbidden-remedy": Sentence(
        "sudo usermod -aG gpio $USER, then log in again.",
        "sudo usermod -aG gpio $USER, e entre de novo.",
        "sudo usermod -aG gpio $USER, y entra otra vez.",
    ),
    "doctor-reset-absent": Sentence(
        "this machine has no GPIO{pin} to restart the robot's board.",
        "esta máquina não tem GPIO{pin} para reiniciar a placa do robô.",
        "esta máquina no tiene GPIO{pin} para reiniciar la placa del robot.",
    ),
    "doctor-reset-absent-remedy": Sentence(
        "name another line: reset_line in the settings, such as dtr.",
        "escolha outra linha: reset_line nas configurações, como dtr.",
        "elige otra línea: reset_line en los ajustes, como dtr.",
    ),
    "doctor-reset-failed": Sentence(
        "the pins of this machine can't be used, so GPIO{pin} can't restart the robot's board.",
        "os pinos desta máquina não podem ser usados, e GPIO{pin} não reinicia a placa do robô.",
        "los pines de esta máquina no se pueden usar, y GPIO{pin} no reinicia la placa del robot.",
    ),
    "doctor-reset-failed-remedy": Sentence(
        "does another program use them? The robot's switch stops it too.",
        "outro programa usa os pinos? O interruptor do robô também o para.",
        "¿otro programa los usa? El interruptor del robot también lo detiene.",
    ),
    # --- settings
    "doctor-settings-file": Sentence(
        "Settings file: {path}", "Arquivo de ajustes: {path}", "Archivo de ajustes: {path}"
    ),
    "doctor-no-settings-file": Sentence(
        "No settings file yet; it would be {path}",
        "Ainda sem arquivo de ajustes; seria {path}",
        "Aún sin archivo de ajustes; sería {path}",
    ),
    "doctor-setting-option": Sentence(
        "{key} is {value}, from the command line.",
        "{key} é {value}, da linha de comando.",
        "{key} es {value}, de la línea de comandos.",
    ),
    "doctor-setting-environment": Sentence(
        "{key} is {value}, from {variable}.",
        "{key} é {value}, de {variable}.",
        "{key} es {value}, de {variable}.",
    ),
    "doctor-setting-file": Sentence(
        "{key} is {value}, from the settings file.",
        "{key} é {value}, do arquivo de ajustes.",
        "{key} es {value}, del archivo de ajustes.",
    ),
}
