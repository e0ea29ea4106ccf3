"""The same as model.yaml, in Python: files of every library come into being."""
import cnrg

model = cnrg.box([0, 0, 0], [2, 2, 2], material="rock") - cnrg.box([1, 1, 1], ["10/3", 3, 3])
result = model.evaluate()
assert result.volume == 7, result.volume
for name in ("python.json", "python.step", "python.h5m"):
    result.write(name)
result.picture("python.png")
print(cnrg.__version__)
