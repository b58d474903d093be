"""The command line: what can't be done, what is still to come, and the settings."""

from donnie_tui.i18n.sentence import Sentence

SENTENCES: dict[str, Sentence] = {
    # --- still to come
    "command-to-come": Sentence(
        "The command {command} is not there yet.",
        "O comando {command} ainda não existe.",
        "La orden {command} aún no existe.",
    ),
    "option-to-come": Sentence(
        "The option {option} is not there yet.",
        "A opção {option} ainda não existe.",
        "La opción {option} aún no existe.",
    ),
    "robot-to-come": Sentence(
        "The robot {robot} is not there yet. Use sim, the simulator.",
        "O robô {robot} ainda não existe. Use sim, o simulador.",
        "El robot {robot} aún no existe. Usa sim, el simulador.",
    ),
    "several-robots-to-come": Sentence(
        "Several robots at once are not there yet.",
        "Vários robôs ao mesmo tempo ainda não existem.",
        "Varios robots a la vez aún no existen.",
    ),
    # --- wrong usage
    "bad-option": Sentence(
        "The option {option} can't be {value}. It takes {wanted}.",
        "A opção {option} não pode ser {value}. Ela aceita {wanted}.",
        "La opción {option} no puede ser {value}. Acepta {wanted}.",
    ),
    "events-need-run": Sentence(
        "Events go to a file here. The option --events - is for donnie run.",
        "Aqui os eventos vão para um arquivo. A opção --events - é de donnie run.",
        "Aquí los eventos van a un archivo. La opción --events - es de donnie run.",
    ),
    "unknown-command-line": Sentence(
        "{problem}. The option --help tells more.",
        "{problem}. A opção --help diz mais.",
        "{problem}. La opción --help dice más.",
    ),
    # --- settings
    "setting-unknown": Sentence(
        "The settings file has an unknown word, {name}.",
        "O arquivo de configurações tem uma palavra desconhecida, {name}.",
        "El archivo de ajustes tiene una palabra desconocida, {name}.",
    ),
    "setting-not-understood": Sentence(
        "In the settings file, {name} can't be {value}. It takes {wanted}.",
        "No arquivo de configurações, {name} não pode ser {value}. Aceita {wanted}.",
        "En el archivo de ajustes, {name} no puede ser {value}. Acepta {wanted}.",
    ),
    "variable-not-understood": Sentence(
        "The variable {name} can't be {value}. It takes {wanted}.",
        "A variável {name} não pode ser {value}. Aceita {wanted}.",
        "La variable {name} no puede ser {value}. Acepta {wanted}.",
    ),
    "settings-file-damaged": Sentence(
        "The settings file can't be read, line {line}. Defaults are used.",
        "O arquivo de configurações não pode ser lido, linha {line}. Valem os padrões.",
        "El archivo de ajustes no se puede leer, línea {line}. Valen los predeterminados.",
    ),
    "settings-file-unreadable": Sentence(
        "The settings file can't be read. Defaults are used.",
        "O arquivo de configurações não pode ser lido. Valem os padrões.",
        "El archivo de ajustes no se puede leer. Valen los predeterminados.",
    ),
    # --- check
    "check-line": Sentence(
        "{file}:{line}:{column}: {kind}: {message}",
        "{file}:{line}:{column}: {kind}: {message}",
        "{file}:{line}:{column}: {kind}: {message}",
    ),
    "check-clean": Sentence("{file}: no mistakes.", "{file}: sem erros.", "{file}: sin errores."),
    # --- worlds
    "world-title": Sentence("{name}: {title}.", "{name}: {title}.", "{name}: {title}."),
    "stopped-at": Sentence(
        "Stopped at line {line}.", "Parado na linha {line}.", "Detenido en la línea {line}."
    ),
}
