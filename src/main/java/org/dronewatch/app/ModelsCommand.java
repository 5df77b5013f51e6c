package org.dronewatch.app;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.dronewatch.models.Mesh;
import org.dronewatch.models.ModelCatalogue;
import org.dronewatch.report.WholeFile;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Writes the packaged models again. */
@Command(
        name = "models",
        mixinStandardHelpOptions = true,
        description = "Writes the packaged models, which are made by code, byte for byte as they are shipped.",
        footer = {"", "Example:", "  dronewatch models --out my-models"})
final class ModelsCommand implements Callable<Integer> {
    @Option(
            names = "--out",
            required = true,
            paramLabel = "DIR",
            description = "An existing directory to write into; files of the same names are replaced.")
    private Path out;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        if (!Files.isDirectory(out)) {
            throw new InputException("--out " + PlainText.value(out) + ": there is no such directory");
        }
        for (ModelCatalogue model : ModelCatalogue.all()) {
            write(model.mesh());
        }
        return 0;
    }

    private void write(Mesh mesh) {
        ModelCatalogue.files(mesh).forEach((name, bytes) -> {
            new WholeFile("--out", out.resolve(name).toString()).write(stream -> stream.write(bytes));
            spec.commandLine().getOut().printf("%s: %,d bytes%n", out.resolve(name), bytes.length);
        });
    }
}
