package org.dronewatch.app;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import org.dronewatch.app.console.ExitCode;
import org.dronewatch.app.console.Notes;
import org.dronewatch.app.option.JsonOption;
import org.dronewatch.app.option.PathWord;
import org.dronewatch.app.option.StoreSwitch;
import org.dronewatch.app.option.ThreadsOption;
import org.dronewatch.report.provenance.ProvenanceFile;
import org.dronewatch.report.provenance.RecordedCommand;
import org.dronewatch.report.provenance.SameBytes;
import org.dronewatch.run.store.StorePlace;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** Repeats a run or a campaign, and compares the results. */
@Command(
        name = "again",
        mixinStandardHelpOptions = true,
        description = {
            "Repeats the run, campaign, comparison, search for routes or placement that a provenance.json records, and"
                    + " states, for each result file in the same directory, whether the new one is byte-identical to it; the exit"
                    + " code is 1 if any differs.",
            "Relative paths are resolved from the current directory, as in the first run."
        },
        footer = {"", "Example:", "  dronewatch again results/provenance.json"})
final class AgainCommand implements Callable<Integer> {
    @Parameters(index = "0", paramLabel = "PROVENANCE.json", description = "File that records what was run.")
    private String file;

    @Option(
            names = "--out",
            paramLabel = "DIR",
            description = "New directory for the new results; without it, they are not kept.")
    private String out;

    @Mixin
    private ThreadsOption threads = new ThreadsOption();

    @Mixin
    private JsonOption json = new JsonOption();

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        Path given = PathWord.of("", file).toAbsolutePath();
        RecordedCommand recorded = RecordedCommand.read(given);
        Replay replay = new Replay(given, recorded);
        if (out != null) {
            Path target = PathWord.of("--out", out);
            if (Files.exists(target)) {
                throw new InputException("--out " + PlainText.value(out) + ": already exists: choose a new directory");
            }
            return repeat(given, recorded, replay, target);
        }
        Path temporary = Files.createTempDirectory("dronewatch-again-");
        try {
            return repeat(given, recorded, replay, temporary.resolve("results"));
        } finally {
            delete(temporary);
        }
    }

    private int repeat(Path given, RecordedCommand recorded, Replay replay, Path target) {
        List<String> words = replay.words(target);
        words.add("--threads=" + threads.number());
        if (Notes.areOff(spec)) {
            words.add("--quiet");
        }
        if (StoreSwitch.of(spec).equals(StorePlace.NONE)) {
            words.add("--no-cache");
        }
        int code = Main.execute(
                new PrintWriter(Writer.nullWriter()), spec.commandLine().getErr(), words.toArray(String[]::new));
        if (code != 0) {
            return code;
        }
        List<String> changed = recorded.differences(RecordedCommand.read(target.resolve(ProvenanceFile.NAME)));
        Map<String, SameBytes.State> states = SameBytes.compare(given.resolveSibling(""), target);
        boolean same = !states.isEmpty() && states.values().stream().allMatch(state -> state == SameBytes.State.SAME);
        json.print(() -> toJson(same, changed, states), out -> print(same, changed, states, out));
        return same ? 0 : ExitCode.FAILED;
    }

    private static void print(
            boolean same, List<String> changed, Map<String, SameBytes.State> states, PrintWriter out) {
        if (!changed.isEmpty()) {
            out.println("changed since the recorded run: " + String.join(", ", changed));
        }
        states.forEach((name, state) -> out.printf("%-9s  %s%n", word(state), PlainText.value(name)));
        out.println(same ? "the results are byte-identical" : "the results differ");
    }

    private static ObjectNode toJson(boolean same, List<String> changed, Map<String, SameBytes.State> states) {
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        root.put("same", same);
        ArrayNode since = root.putArray("changed");
        changed.forEach(since::add);
        ObjectNode files = root.putObject("files");
        states.forEach((name, state) -> files.put(name, word(state)));
        return root;
    }

    private static String word(SameBytes.State state) {
        return state.name().toLowerCase(Locale.ROOT);
    }

    private static void delete(Path directory) throws IOException {
        try (Stream<Path> files = Files.walk(directory)) {
            for (Path one : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(one);
            }
        }
    }
}
