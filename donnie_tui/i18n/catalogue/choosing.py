"""Choosing a robot and a world from a list, in words."""

from donnie_tui.i18n.sentence import Sentence

SENTENCES: dict[str, Sentence] = {
    "ask-connect": Sentence("Robots to connect to", "Robôs para conectar", "Robots para conectar"),
    "ask-robot": Sentence("Robots of this world", "Robôs deste mundo", "Robots de este mundo"),
    "connect-choice-missing": Sentence(
        "{number}: {what}, not plugged in.", "{number}: {what}, desligado.", "{number}: {what}, desconectado."
    ),
    "connect-choice-forbidden": Sentence(
        "{number}: {what}, you may not open it.",
        "{number}: {what}, você não pode abrir.",
        "{number}: {what}, no puedes abrirlo.",
    ),
    "world-row": Sentence(
        "{name}: {title}, {difficulty}. {about} Task: {task}",
        "{name}: {title}, {difficulty}. {about} Tarefa: {task}",
        "{name}: {title}, {difficulty}. {about} Tarea: {task}",
    ),
    "worlds-count": Sentence(
        "{count} worlds. WORLD with a name goes there.",
        "{count} mundos. MUNDO com um nome vai para lá.",
        "{count} mundos. MUNDO con un nombre va allí.",
        brief=(
            "{count} worlds. WORLD NAME goes there.",
            "{count} mundos. MUNDO NOME vai lá.",
            "{count} mundos. MUNDO NOMBRE va allí.",
        ),
    ),
    "worlds-line": Sentence(
        "{name}: {title}, {difficulty}.",
        "{name}: {title}, {difficulty}.",
        "{name}: {title}, {difficulty}.",
        brief=("{name}, {difficulty}.", "{name}, {difficulty}.", "{name}, {difficulty}."),
    ),
    "worlds-line-here": Sentence(
        "{name}: {title}, {difficulty}. You are here.",
        "{name}: {title}, {difficulty}. Você está aqui.",
        "{name}: {title}, {difficulty}. Estás aquí.",
        brief=("{name}, {difficulty}, here.", "{name}, {difficulty}, aqui.", "{name}, {difficulty}, aquí."),
    ),
    "world-unknown-here": Sentence(
        "There is no world {name}. WORLDS lists them.",
        "Não existe o mundo {name}. MUNDOS lista todos.",
        "No existe el mundo {name}. MUNDOS los lista.",
        brief=(
            "No world {name}. See WORLDS.",
            "Não há {name}. Veja MUNDOS.",
            "No hay {name}. Ve MUNDOS.",
        ),
    ),
    "world-here": Sentence(
        "This is the world {name}.",
        "Este é o mundo {name}.",
        "Este es el mundo {name}.",
        brief=("World: {name}.", "Mundo: {name}.", "Mundo: {name}."),
    ),
    "world-here-titled": Sentence(
        "This is the world {name}: {title}.",
        "Este é o mundo {name}: {title}.",
        "Este es el mundo {name}: {title}.",
        brief=("World: {title}.", "Mundo: {title}.", "Mundo: {title}."),
    ),
    "world-has": Sentence(
        "{count} {count:thing|things}. WORLD tells more.",
        "{count} {count:objeto|objetos}. MUNDO diz mais.",
        "{count} {count:objeto|objetos}. MUNDO dice más.",
    ),
    "world-here-already": Sentence(
        "You are in {name} already. RESET goes to the start.",
        "Você já está em {name}. REINICIAR volta ao início.",
        "Ya estás en {name}. REINICIAR vuelve al inicio.",
        brief=("You are in {name}.", "Você está em {name}.", "Estás en {name}."),
    ),
    "word-takes-nothing": Sentence(
        "{word} takes nothing behind it. Type {word} alone.",
        "{word} não leva nada depois. Digite só {word}.",
        "{word} no lleva nada detrás. Escribe solo {word}.",
        brief=("Type {word} alone.", "Digite só {word}.", "Escribe solo {word}."),
    ),
}
