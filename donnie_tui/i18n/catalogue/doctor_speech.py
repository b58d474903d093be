"""What ``donnie doctor`` says of readers, voices and sounds."""

from donnie_tui.i18n.sentence import Sentence

SENTENCES: dict[str, Sentence] = {
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
}
