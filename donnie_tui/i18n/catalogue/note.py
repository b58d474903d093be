"""A world file that loads: what was ignored or repaired in it."""

from donnie_tui.i18n.sentence import Sentence

SENTENCES: dict[str, Sentence] = {
    "note-at": Sentence(
        "Line {line} of {file}: {remark}",
        "Linha {line} de {file}: {remark}",
        "Línea {line} de {file}: {remark}",
    ),
    "note-unknown-property": Sentence(
        "the property {name} is not known.",
        "a propriedade {name} não é conhecida.",
        "la propiedad {name} no se conoce.",
    ),
    "note-unknown-property-near": Sentence(
        "the property {name} is not known. Did you mean {nearest}?",
        "a propriedade {name} não é conhecida. Você quis dizer {nearest}?",
        "la propiedad {name} no se conoce. Quizá querías decir {nearest}.",
    ),
    "note-unused-property": Sentence(
        "the property {name} has no effect.",
        "a propriedade {name} não tem efeito.",
        "la propiedad {name} no tiene efecto.",
    ),
    "note-not-simulated": Sentence(
        "{name}, a {type}, is kept but not simulated.",
        "{name}, um {type}, é guardado, mas não simulado.",
        "{name}, un {type}, se guarda, pero no se simula.",
    ),
    "note-second-define": Sentence(
        "{name} is defined twice. The first one counts.",
        "{name} é definido duas vezes. Vale o primeiro.",
        "{name} se define dos veces. Vale el primero.",
    ),
    "note-unknown-colour": Sentence(
        "the colour {name} is not known; red is taken.",
        "a cor {name} não é conhecida; fica vermelho.",
        "el color {name} no se conoce; queda rojo.",
    ),
    "note-unknown-colour-near": Sentence(
        "the colour {name} is not known; red is taken. Did you mean {nearest}?",
        "a cor {name} não é conhecida; fica vermelho. Você quis dizer {nearest}?",
        "el color {name} no se conoce; queda rojo. Quizá querías decir {nearest}.",
    ),
    "note-random-colour": Sentence(
        "the colour random is one of seven, each time the same.",
        "a cor random é uma de sete, sempre a mesma.",
        "el color random es uno de siete, siempre el mismo.",
    ),
    "note-lone-sensor": Sentence(
        "the lone sensor became a ranger.",
        "o sensor sozinho virou um ranger.",
        "el sensor suelto pasó a ser un ranger.",
    ),
    "note-walls-made-solid": Sentence(
        "{name} is solid now.", "{name} agora é sólido.", "{name} ahora es sólido."
    ),
    "note-not-utf8": Sentence(
        "{path} is not UTF-8. I read it as Latin-1.",
        "{path} não é UTF-8. Li como Latin-1.",
        "{path} no es UTF-8. Lo leí como Latin-1.",
    ),
    "note-margin-cropped": Sentence(
        "The white margin of {path} was cropped.",
        "A margem branca de {path} foi cortada.",
        "El margen blanco de {path} se recortó.",
    ),
    "note-driver-not-used": Sentence(
        "the driver {name} is not needed here.",
        "o driver {name} não é necessário aqui.",
        "el driver {name} no hace falta aquí.",
    ),
    "note-unknown-model": Sentence(
        "the world has no model {name}.",
        "o mundo não tem o modelo {name}.",
        "el mundo no tiene el modelo {name}.",
    ),
    "note-unknown-model-near": Sentence(
        "the world has no model {name}. Did you mean {nearest}?",
        "o mundo não tem o modelo {name}. Você quis dizer {nearest}?",
        "el mundo no tiene el modelo {name}. Quizá querías decir {nearest}.",
    ),
    "note-robot-without-name": Sentence(
        "A robot without a usable name is called {alias}.",
        "Um robô sem nome que sirva se chama {alias}.",
        "Un robot sin nombre que sirva se llama {alias}.",
    ),
    "note-robot-renamed": Sentence(
        "Another robot {name} is called {alias}.",
        "Outro robô {name} se chama {alias}.",
        "Otro robot {name} se llama {alias}.",
    ),
    "note-starts-inside": Sentence(
        "Robot {name} begins inside {thing}. One of them needs another pose.",
        "O robô {name} começa dentro de {thing}. Mude a pose de um deles.",
        "El robot {name} empieza dentro de {thing}. Cambia la pose de uno.",
        brief=(
            "Robot {name} begins inside {thing}.",
            "O robô {name} começa dentro de {thing}.",
            "El robot {name} empieza dentro de {thing}.",
        ),
    ),
    "world-words-file": Sentence(
        "I can't read {file}, so the world has no words.",
        "Não consigo ler {file}; o mundo fica sem palavras.",
        "No puedo leer {file}; el mundo queda sin palabras.",
    ),
    "world-words-line": Sentence(
        "I can't read line {line} of {file}, so the world has no words.",
        "Não entendo a linha {line} de {file}; o mundo fica sem palavras.",
        "No entiendo la línea {line} de {file}; el mundo queda sin palabras.",
    ),
    "world-words-difficulty": Sentence(
        "In {file} difficulty takes easy, medium or hard, so the world has no words.",
        "Em {file} difficulty aceita easy, medium ou hard; o mundo fica sem palavras.",
        "En {file} difficulty acepta easy, medium o hard; el mundo queda sin palabras.",
    ),
    "world-words-key": Sentence(
        "In {file} {key} is missing or wrong, so the world has no words.",
        "Em {file} falta {key} ou está errado; o mundo fica sem palavras.",
        "En {file} falta {key} o está mal; el mundo queda sin palabras.",
    ),
    "world-remarks": Sentence(
        "{count} {count:slip|slips} in the world. donnie world {path} --report tells {count:it|them}.",
        "{count} {count:deslize|deslizes} no mundo. donnie world {path} --report {count:o|os} diz.",
        "{count} {count:descuido|descuidos} en el mundo. donnie world {path} --report {count:lo|los} dice.",
        brief=(
            "{count} {count:slip|slips} in the world. See --report.",
            "{count} {count:deslize|deslizes} no mundo. Veja --report.",
            "{count} {count:descuido|descuidos} en el mundo. Ve --report.",
        ),
    ),
    "note-no-robot": Sentence("The world has no robot.", "O mundo não tem robô.", "El mundo no tiene robot."),
}
