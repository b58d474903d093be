-- anda em um quadrado
REPITA 4 VEZES
  PF 2
  GD 90
FIM REPITA
ESTADO
FALAR "pronto"
