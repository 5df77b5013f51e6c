package org.dronewatch.app.option;

import java.io.PrintWriter;
import java.util.function.Consumer;
import java.util.function.Supplier;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import tools.jackson.core.json.JsonWriteFeature;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** The option {@code --json}, for commands whose tables other programs may read. */
public final class JsonOption {
    @Option(
            names = "--json",
            description = "Prints a single JSON object on standard output instead of tables; everything else goes to"
                    + " standard error.")
    private boolean json;

    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    /** Whether a JSON object is asked for. */
    public boolean isAsked() {
        return json;
    }

    /**
     * Prints the results of the command, in the form that the user has chosen.
     *
     * @param object returns the results as a JSON object
     * @param tables prints the results as tables, for people
     */
    public void print(Supplier<ObjectNode> object, Consumer<PrintWriter> tables) {
        PrintWriter out = command.commandLine().getOut();
        if (json) {
            out.println(json(object.get()));
        } else {
            tables.accept(out);
        }
    }

    /**
     * As pure ASCII text: what a program reads must not depend on the console's character set. The mapper is made
     * here, since it takes a fifth of the time in which other commands start.
     */
    private static String json(ObjectNode object) {
        return JsonMapper.builder()
                .enable(JsonWriteFeature.ESCAPE_NON_ASCII)
                .build()
                .writerWithDefaultPrettyPrinter()
                .writeValueAsString(object)
                .replace("\r\n", "\n");
    }
}
