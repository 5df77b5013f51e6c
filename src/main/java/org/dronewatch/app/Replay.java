package org.dronewatch.app;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.dronewatch.campaign.CampaignSettings;
import org.dronewatch.report.provenance.RecordedCommand;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scenes.PackagedScene;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;

/**
 * A command of a {@code provenance.json} as it may be run again: only options that affect the results are kept, files
 * are written only into the new directory, and no class is loaded by its name.
 */
final class Replay {
    private static final String RUN = "run";
    private static final String CAMPAIGN = "campaign";
    private static final String COMPARE = "compare";
    private static final String ROUTE = "route";
    private static final String PLACE = "place";

    private static final String SHARD = "--shard";

    /** The options that affect the results. */
    private static final Set<String> KEPT = Set.of(
            "--set",
            "--with",
            "--vary",
            "--seed",
            "--observations",
            "--labels",
            "--samples",
            "--runs",
            "--drone",
            "--side",
            "--cell",
            "--heights",
            "--launch",
            "--response",
            "--modes",
            "--stopped",
            "--pointing",
            "--proof",
            "--budget",
            "--budgets",
            "--gap",
            "--campaign",
            SHARD);

    private final Path file;
    private final ParseResult parsed;

    /**
     * Reads a recorded command.
     *
     * @param file file that records it, for messages
     * @throws InputException when it is not one that can be repeated
     */
    Replay(Path file, RecordedCommand recorded) {
        this.file = file;
        CommandLine commands = Commands.program(new Main(), recorded.words());
        commands.setExpandAtFiles(false);
        commands.setCaseInsensitiveEnumValuesAllowed(true);
        try {
            ParseResult all = commands.parseArgs(recorded.words().toArray(String[]::new));
            this.parsed = all.subcommand();
        } catch (ParameterException e) {
            throw refusal("its command cannot be read: " + WrongUsage.message(e));
        }
        if (parsed == null || !Set.of(RUN, CAMPAIGN, COMPARE, ROUTE, PLACE).contains(name())) {
            throw refusal("only 'run', 'campaign', 'compare', 'route' and 'place' can be repeated");
        }
    }

    private InputException refusal(String reason) {
        return new InputException(PlainText.value(file) + ": " + reason);
    }

    private String name() {
        return parsed.commandSpec().name();
    }

    /** The recorded command itself, a campaign. */
    CampaignCommand campaign() {
        if (parsed.commandSpec().userObject() instanceof CampaignCommand campaign) {
            return campaign;
        }
        throw refusal("does not record a campaign");
    }

    /** The words of the command that runs the whole campaign of which the recorded one ran a part. */
    List<String> wordsOfAll(Path out) {
        return words(out).stream().filter(word -> !word.startsWith(SHARD)).toList();
    }

    /**
     * The words of the command that writes the results into another directory.
     *
     * @param out that directory
     */
    List<String> words(Path out) {
        List<String> words = new ArrayList<>(List.of(name()));
        for (PositionalParamSpec positional : parsed.matchedPositionals()) {
            for (String value : positional.originalStringValues()) {
                words.add(checked(value));
            }
        }
        for (OptionSpec option : new LinkedHashSet<>(parsed.matchedOptions())) {
            if (KEPT.contains(option.longestName())) {
                option.originalStringValues().forEach(this::checkScene);
                add(option, words);
            }
        }
        words.add("--out=" + out);
        return words;
    }

    private String checked(String value) {
        if (value.startsWith("@") || value.startsWith("-")) {
            throw refusal("'" + PlainText.value(value) + "' is not the name of a scene");
        }
        if (!name().equals(CAMPAIGN)
                && !SceneFile.isFileName(value)
                && PackagedScene.find(value).isEmpty()) {
            throw refusal("the scene '" + PlainText.value(value)
                    + "' is a class, and a class is not loaded merely because a file names it: run it yourself");
        }
        return value;
    }

    /** Checks a setting, which may name the scene of a variant. */
    private void checkScene(String value) {
        int equals = value.indexOf('=');
        if (equals > 0 && value.substring(0, equals).strip().equals(CampaignSettings.SCENE)) {
            checked(value.substring(equals + 1).strip());
        }
    }

    private static void add(OptionSpec option, List<String> words) {
        if (isSwitch(option)) {
            words.add(option.longestName());
        } else {
            option.originalStringValues().forEach(value -> words.add(option.longestName() + "=" + value));
        }
    }

    private static boolean isSwitch(ArgSpec option) {
        return option.arity().max() == 0;
    }
}
