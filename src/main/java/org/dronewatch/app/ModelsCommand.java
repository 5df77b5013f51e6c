package org.dronewatch.app;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.Callable;
import org.dronewatch.app.option.JsonOption;
import org.dronewatch.models.ModelCatalogue;
import org.dronewatch.report.file.WholeFile;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** Writes the packaged models again. */
@Command(
        name = "models",
        mixinStandardHelpOptions = true,
        description = "Regenerates the packaged models, byte-identical to those shipped.",
        footer = {"", "Example:", "  dronewatch models --out my-models"})
final class ModelsCommand implements Callable<Integer> {
    @Option(
            names = "--out",
            required = true,
            paramLabel = "DIR",
            description = "An existing directory to write into; files of the same names are replaced.")
    private Path out;

    @Mixin
    private JsonOption json = new JsonOption();

    @Override
    public Integer call() {
        if (!Files.isDirectory(out)) {
            throw new InputException("--out " + PlainText.value(out) + ": there is no such directory");
        }
        Map<Path, Integer> sizes = new LinkedHashMap<>();
        for (ModelCatalogue model : ModelCatalogue.all()) {
            ModelCatalogue.files(model.mesh()).forEach((name, bytes) -> {
                Path file = out.resolve(name);
                new WholeFile("--out", file.toString()).write(stream -> stream.write(bytes));
                sizes.put(file, bytes.length);
            });
        }
        json.print(
                () -> toJson(sizes),
                tables -> sizes.forEach((file, size) -> tables.printf("%s: %,d bytes%n", file, size)));
        return 0;
    }

    private static ObjectNode toJson(Map<Path, Integer> sizes) {
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        ArrayNode files = root.putArray("files");
        sizes.forEach(
                (file, size) -> files.addObject().put("file", file.toString()).put("bytes", size));
        return root;
    }
}
