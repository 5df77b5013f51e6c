package org.dronewatch.app;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import picocli.CommandLine;

/**
 * The commands of the program, in the order of the help. Reading the annotations of all of them takes longer than
 * starting Java, so only those of the given command are read, unless others are needed.
 */
final class Commands {
    private static final Map<String, Class<?>> ALL = all();

    private static final Set<String> ABOUT_OTHERS = Set.of("completion", "help");

    private Commands() {}

    private static Map<String, Class<?>> all() {
        Map<String, Class<?>> all = new LinkedHashMap<>();
        all.put("list", ListCommand.class);
        all.put("run", RunCommand.class);
        all.put("view", ViewCommand.class);
        all.put("check", CheckCommand.class);
        all.put("new", NewCommand.class);
        all.put("height", HeightCommand.class);
        all.put("save", SaveCommand.class);
        all.put("schema", SchemaCommand.class);
        all.put("render", RenderCommand.class);
        all.put("coverage", CoverageCommand.class);
        all.put("route", RouteCommand.class);
        all.put("place", PlaceCommand.class);
        all.put("campaign", CampaignCommand.class);
        all.put("compare", CompareCommand.class);
        all.put("merge", MergeCommand.class);
        all.put("again", AgainCommand.class);
        all.put("alarms", AlarmsCommand.class);
        all.put("calibrate", CalibrateCommand.class);
        all.put("bench", BenchCommand.class);
        all.put("costs", CostsCommand.class);
        all.put("models", ModelsCommand.class);
        all.put("completion", CompletionCommand.class);
        all.put("help", HelpCommand.class);
        return Collections.unmodifiableMap(all);
    }

    /** The program with all its commands. */
    static CommandLine program(Main main) {
        return with(main, ALL);
    }

    /**
     * The program with only those commands that these words need: the one that they name, or all commands if they name
     * none, one that does not exist, or one that is about the others.
     */
    static CommandLine program(Main main, List<String> words) {
        // None of the options that may come before a command has a value.
        String given = words.stream()
                .filter(word -> !word.startsWith("-") || word.equals("--"))
                .findFirst()
                .orElse("");
        boolean isEnough = ALL.containsKey(given) && !ABOUT_OTHERS.contains(given);
        return with(main, isEnough ? Map.of(given, ALL.get(given)) : ALL);
    }

    private static CommandLine with(Main main, Map<String, Class<?>> commands) {
        CommandLine program = new CommandLine(main);
        commands.forEach((name, type) -> program.addSubcommand(name, new CommandLine(type)));
        return program;
    }
}
