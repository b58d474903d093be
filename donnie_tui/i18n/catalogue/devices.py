"""Voice and sound: what is missing, and what was decided about them."""

from donnie_tui.i18n.sentence import Sentence

SENTENCES: dict[str, Sentence] = {
    "no-sound-device": Sentence(
        "No sound device. Everything is in print.",
        "Sem dispositivo de som. Tudo fica escrito.",
        "Sin dispositivo de sonido. Todo se escribe.",
        brief=(
            "No sound device. All is in print.",
            "Sem som. Tudo fica escrito.",
            "Sin sonido. Todo se escribe.",
        ),
    ),
    "no-voice": Sentence(
        "No voice, espeak-ng is missing. Sounds and print work.",
        "Sem voz, falta espeak-ng. Sons e texto funcionam.",
        "Sin voz, falta espeak-ng. Sonidos y texto funcionan.",
        brief=(
            "No voice: espeak-ng is missing.",
            "Sem voz: falta espeak-ng.",
            "Sin voz: falta espeak-ng.",
        ),
    ),
    "voice-missing": Sentence(
        "No voice for {language}. It is in print only.",
        "Sem voz para {language}. Fica só escrito.",
        "Sin voz para {language}. Solo se escribe.",
        brief=(
            "No voice for {language}. In print only.",
            "Sem voz para {language}. Só escrito.",
            "Sin voz para {language}. Solo escrito.",
        ),
    ),
    "audio-gave-up": Sentence(
        "The sound failed. All is in print. To hear again, restart Donnie.",
        "O som falhou. Tudo fica escrito. Para ouvir de novo, reinicie o Donnie.",
        "El sonido falló. Todo se escribe. Para oír otra vez, reinicia Donnie.",
        brief=(
            "Sound failed. To hear, restart Donnie.",
            "Som falhou. Reinicie o Donnie.",
            "Sonido falló. Reinicia Donnie.",
        ),
    ),
    "speech-backlog": Sentence(
        "Too much to say. Some of it is in print only.",
        "Há coisas demais para falar. Parte fica só escrita.",
        "Hay demasiado que decir. Una parte solo se escribe.",
        brief=(
            "Too much to say: some only in print.",
            "Muito para falar: parte só escrita.",
            "Mucho que decir: parte solo escrita.",
        ),
    ),
    "no-speech-dispatcher": Sentence(
        "No speech-dispatcher here. All is in print.",
        "Não há speech-dispatcher. Tudo fica escrito.",
        "No hay speech-dispatcher. Todo se escribe.",
        brief=(
            "No speech-dispatcher. All in print.",
            "Sem speech-dispatcher. Tudo escrito.",
            "Sin speech-dispatcher. Todo escrito.",
        ),
    ),
    "ssip-silent": Sentence(
        "speech-dispatcher is silent. Has it a sound device?",
        "O speech-dispatcher não soa. Ele tem som?",
        "speech-dispatcher no suena. ¿Tiene sonido?",
        brief=(
            "speech-dispatcher is silent.",
            "O speech-dispatcher não soa.",
            "speech-dispatcher no suena.",
        ),
    ),
    "ssip-lost": Sentence(
        "speech-dispatcher is gone. All is in print. SET speech auto looks again.",
        "O speech-dispatcher sumiu. Tudo fica escrito. AJUSTAR fala auto procura de novo.",
        "speech-dispatcher se fue. Todo se escribe. AJUSTAR voz auto busca otra vez.",
        brief=(
            "Voice gone. SET speech auto looks again.",
            "Voz sumiu. AJUSTAR fala auto a procura.",
            "Sin voz. AJUSTAR voz auto la busca.",
        ),
    ),
    "voice-for-reader": Sentence(
        "Voice off, a screen reader runs. SET speech own turns it on.",
        "Voz desligada, há um leitor de tela. AJUSTAR fala própria a liga.",
        "Voz apagada, hay un lector de pantalla. AJUSTAR voz propia la enciende.",
        brief=(
            "Voice off. SET speech own turns it on.",
            "Sem voz. AJUSTAR fala própria a liga.",
            "Sin voz. AJUSTAR voz propia la enciende.",
        ),
    ),
    "voice-over-ssh": Sentence(
        "Voice off over SSH. SET speech own turns it on.",
        "Voz desligada por SSH. AJUSTAR fala própria a liga.",
        "Voz apagada por SSH. AJUSTAR voz propia la enciende.",
        brief=(
            "Voice off. SET speech own turns it on.",
            "Sem voz. AJUSTAR fala própria a liga.",
            "Sin voz. AJUSTAR voz propia la enciende.",
        ),
    ),
    "voice-own": Sentence(
        "I speak with my own voice. SET speech off ends it.",
        "Falo com voz própria. Para calar: AJUSTAR fala não.",
        "Hablo con voz propia. Para callar: AJUSTAR voz no.",
        brief=(
            "My own voice. SET speech off ends it.",
            "Voz própria. Calar: AJUSTAR fala não.",
            "Voz propia. Callar: AJUSTAR voz no.",
        ),
    ),
    "voice-by-dispatcher": Sentence(
        "I speak by speech-dispatcher. SET speech off ends it.",
        "Falo pelo speech-dispatcher. Para calar: AJUSTAR fala não.",
        "Hablo por speech-dispatcher. Para callar: AJUSTAR voz no.",
        brief=(
            "Voice: ssip. SET speech off ends it.",
            "Voz: ssip. Calar: AJUSTAR fala não.",
            "Voz: ssip. Callar: AJUSTAR voz no.",
        ),
    ),
    "voice-behind-reader": Sentence(
        "I speak behind your screen reader. SET speech off ends it.",
        "Falo depois do seu leitor de tela. Para calar: AJUSTAR fala não.",
        "Hablo detrás de tu lector de pantalla. Para callar: AJUSTAR voz no.",
        brief=(
            "Voice: reader's. SET speech off ends it.",
            "Voz do leitor. Calar: AJUSTAR fala não.",
            "Voz del lector. Callar: AJUSTAR voz no.",
        ),
    ),
    "language-en": Sentence("English", "inglês", "inglés"),
    "language-pt": Sentence("Portuguese", "português", "portugués"),
    "language-es": Sentence("Spanish", "espanhol", "español"),
}
