"""What is said of whatever takes longer than a second: that it goes on, and that it is done."""

from donnie_tui.i18n.sentence import Sentence

SENTENCES: dict[str, Sentence] = {
    "slow-reading": Sentence(
        "Reading {lines} {lines:line|lines} of program.",
        "Lendo {lines} {lines:linha|linhas} de programa.",
        "Leyendo {lines} {lines:línea|líneas} de programa.",
    ),
    "slow-saving": Sentence(
        "Saving {name}, it takes a while.", "Salvando {name}, isso demora.", "Guardando {name}, esto tarda."
    ),
    "slow-layout": Sentence(
        "Laying the program out, it takes a while.",
        "Formatando o programa, isso demora.",
        "Formateando el programa, esto tarda.",
        brief=("Laying it out, it takes a while.", "Formatando, isso demora.", "Formateando, esto tarda."),
    ),
    "slow-opening": Sentence(
        "Opening {name}, it takes a while.", "Abrindo {name}, isso demora.", "Abriendo {name}, esto tarda."
    ),
    "slow-report": Sentence(
        "Writing {name}, it takes a while.",
        "Gravando {name}, isso demora.",
        "Escribiendo {name}, esto tarda.",
    ),
    "slow-connect": Sentence(
        "I still look for the robot. Ctrl+C gives up.",
        "Ainda procuro o robô. Ctrl+C desiste.",
        "Todavía busco el robot. Ctrl+C desiste.",
        brief=(
            "Still looking. Ctrl+C gives up.",
            "Ainda procuro. Ctrl+C desiste.",
            "Sigo buscando. Ctrl+C desiste.",
        ),
    ),
    "slow-world": Sentence(
        "Loading the world {name}, it takes a while.",
        "Carregando o mundo {name}, isso demora.",
        "Cargando el mundo {name}, esto tarda.",
        brief=(
            "Loading {name}, wait a while.",
            "Carregando {name}, isso demora.",
            "Cargando {name}, esto tarda.",
        ),
    ),
    "slow-world-done": Sentence(
        "The world {name} is there.", "O mundo {name} está pronto.", "El mundo {name} está listo."
    ),
    "world-going": Sentence("I go to {name}.", "Vou para {name}.", "Voy a {name}."),
    "world-kept": Sentence(
        "I stay in this world: {path} is being written, and another world would begin it anew. "
        "Leave with QUIT, then start donnie with --world.",
        "Fico neste mundo: {path} está sendo escrito, e outro mundo o começaria de novo. "
        "Saia com SAIR e depois inicie o donnie com --world.",
        "Me quedo en este mundo: {path} se está escribiendo, y otro mundo lo empezaría de nuevo. "
        "Sal con SALIR y después inicia donnie con --world.",
        brief=(
            "I stay. {path} is being written.",
            "Fico. {path} está sendo escrito.",
            "Me quedo. {path} se está escribiendo.",
        ),
    ),
    "text-changed-meanwhile": Sentence(
        "The program was changed meanwhile, so I left it as it is.",
        "O programa mudou enquanto isso, então deixei como está.",
        "El programa cambió mientras tanto, así que lo dejé como está.",
    ),
    "linear-still-reading": Sentence(
        "Still reading the program.", "Ainda lendo o programa.", "Todavía leyendo el programa."
    ),
}
