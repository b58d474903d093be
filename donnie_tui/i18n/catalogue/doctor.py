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
