package org.dronewatch.app;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.dronewatch.app.console.Notes;
import org.dronewatch.placement.plan.PlaceSettings;
import org.dronewatch.report.file.WholeFile;
import org.dronewatch.scenario.PackagedTexts;
import org.dronewatch.scenario.SceneSchema;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Writes the JSON schema of scene files. */
@Command(
        name = "schema",
        mixinStandardHelpOptions = true,
        description = {
            "Prints the JSON schema of scene files, or of placement files, including the kinds that jars on the class"
                    + " path add.",
            "Editors complete and check scene files as you type if their first line is",
            "# yaml-language-server: $schema=scene.schema.json"
        },
        footer = {"", "Example:", "  dronewatch schema --out scene.schema.json"})
final class SchemaCommand implements Callable<Integer> {
    private static final String ENDING = ".json";

    @Option(names = "--out", paramLabel = "FILE", description = "File to write instead of standard output.")
    private String out;

    @Option(names = "--place", description = "Prints the schema of placement files instead of scene files.")
    private boolean place;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        if (out != null && !out.toLowerCase(Locale.ROOT).endsWith(ENDING)) {
            throw new InputException("--out " + PlainText.value(out) + ": must end in " + ENDING);
        }
        WholeFile target = out == null ? null : new WholeFile("--out", out);
        SceneSchema all = new SceneSchema(new PackagedTexts());
        String schema = place ? all.write("dronewatch placement", PlaceSettings.class) : all.write();
        if (target == null) {
            spec.commandLine().getOut().print(schema);
            spec.commandLine().getOut().flush();
        } else {
            target.write(stream -> stream.write(schema.getBytes(StandardCharsets.UTF_8)));
            Notes.of(spec).accept("schema in " + PlainText.value(out));
        }
        return 0;
    }
}
