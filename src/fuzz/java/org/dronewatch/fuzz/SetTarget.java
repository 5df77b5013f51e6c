package org.dronewatch.fuzz;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.InputException;
import tools.jackson.databind.JsonNode;
import tools.jackson.dataformat.yaml.YAMLMapper;

/** Overrides: what {@code check} accepts, {@code run} must be able to do; what it refuses, it reports in one line. */
final class SetTarget implements FuzzTarget {
    private static final String SET = "--set";

    /** Most scenes run without a report, which takes many times as long as they do. */
    private static final String WITHOUT_REPORT = "overrides, without a report";

    /** Coordinates and other lengths: few of them have natural limits. */
    private static final Pattern LENGTH = Pattern.compile(
            "\\.([xyz]|height|distance|radius|range|minRange|maxRange|scale|acceleration|crossSection|power)$");

    private static final Pattern NUMBER = Pattern.compile("-?\\d");

    private final List<String> paths = new ArrayList<>();
    private final List<String> numbers = new ArrayList<>();
    private List<String> lengths = List.of();

    private void collect(String path, JsonNode node) {
        if (!path.isEmpty()) {
            paths.add(path);
        }
        if (node.isValueNode() && NUMBER.matcher(node.asString()).lookingAt()) {
            numbers.add(path);
        }
        node.properties()
                .forEach(part -> collect(path.isEmpty() ? part.getKey() : path + "." + part.getKey(), part.getValue()));
        for (int i = 0; node.isArray() && i < node.size(); i++) {
            collect(path + "." + i, node.get(i));
        }
        if (node.isArray() && node.size() == 3) {
            paths.addAll(List.of(path + ".x", path + ".y", path + ".z"));
        }
    }

    @Override
    public String name() {
        return "set";
    }

    @Override
    public FuzzCase generate(Dice dice, long number) {
        String scene = SampleSite.part(dice);
        paths.clear();
        numbers.clear();
        collect("", YAMLMapper.shared().readTree(scene));
        lengths = paths.stream().filter(path -> LENGTH.matcher(path).find()).toList();
        List<String> arguments = new ArrayList<>(List.of("run", "{}/" + SampleSite.SCENE, "--out", "{}/out"));
        for (int i = dice.oneIn(2) ? 1 : dice.between(2, 5); i > 0; i--) {
            arguments.add(SET);
            arguments.add(
                    dice.oneIn(2)
                            ? number(dice) + "=" + NastyValues.magnitude(dice)
                            : path(dice)
                                    + (dice.oneIn(40) ? dice.pick("", "==", " = ", ":") : "=")
                                    + NastyValues.any(dice));
        }
        String what = dice.oneIn(5) ? "overrides" : WITHOUT_REPORT;
        return SampleSite.scene(what, scene, arguments.toArray(String[]::new));
    }

    /** A path to a number: as often to one of a sensor as to any other. */
    private String number(Dice dice) {
        List<String> ofSensors =
                numbers.stream().filter(path -> path.startsWith("sensors.")).toList();
        return dice.pick(ofSensors.isEmpty() || dice.oneIn(2) ? numbers : ofSensors);
    }

    private String path(Dice dice) {
        String path = dice.pick(dice.oneIn(3) ? lengths : paths);
        if (!dice.oneIn(15)) {
            return path;
        }
        return switch (dice.below(5)) {
            case 0 -> path + "." + NastyValues.name(dice);
            case 1 -> path.substring(0, dice.below(path.length()));
            case 2 -> path.replace('.', dice.pick('/', ' ', ':', '-'));
            case 3 -> path.replaceFirst("[aeiou]", dice.pick("", "x", "e"));
            default -> path.replaceAll("\\.\\d", dice.pick(".-1", ".99", ".1e9", ".2147483648"));
        };
    }

    @Override
    public void judge(FuzzCase input, Path directory) {
        List<String> accepted = new ArrayList<>();
        String[] arguments = input.argumentsIn(directory);
        for (int i = 4; i < arguments.length; i += 2) {
            CommandRun check = Judge.run(directory, "check", arguments[1], SET, arguments[i + 1]);
            if (check.code() == 0) {
                accepted.addAll(List.of(SET, arguments[i + 1]));
            } else if (Messages.mistakes(check.err()).size() != 1) {
                throw new Failure("one line for one override", check.err());
            }
        }
        List<String> command = new ArrayList<>(Arrays.asList(arguments).subList(0, 4));
        command.addAll(accepted);
        if (!isCheap(accepted) || Judge.run(directory, checkOf(command)).code() != 0) {
            return;
        }
        if (input.what().equals(WITHOUT_REPORT)) {
            simulate(Path.of(arguments[1]), accepted);
        } else {
            CommandRun run = Judge.run(directory, command.toArray(String[]::new));
            if (run.code() != 0) {
                throw new Failure(
                        "what check takes, run can do",
                        "exit code " + run.code() + ": " + Messages.firstLine(run.err()));
            }
            ResultFiles.check(directory.resolve("out"), run.out());
        }
    }

    private static void simulate(Path scene, List<String> overrides) {
        SceneRunner runner = new SceneRunner(new SceneFile(scene)).threads(1);
        for (int i = 1; i < overrides.size(); i += 2) {
            String override = overrides.get(i);
            int equals = override.indexOf('=');
            runner.set(
                    override.substring(0, equals).strip(),
                    override.substring(equals + 1).strip());
        }
        try {
            runner.run();
        } catch (InputException e) {
            throw new Failure("what check takes, run can do", e.getMessage());
        }
    }

    private static String[] checkOf(List<String> run) {
        List<String> check = new ArrayList<>(run);
        check.set(0, "check");
        check.subList(2, 4).clear();
        return check.toArray(String[]::new);
    }

    /** Whether a run would be short: some settings are meant to require work without end. */
    private static boolean isCheap(List<String> overrides) {
        return overrides.stream()
                .noneMatch(override -> override.matches(
                        "run\\.duration=.*|.*\\.rate=.*|.*\\.(rays|initialRays|reflectionsPerHit|rayBudget|maxOrder|pulses|mirrorOrder|imageSourceOrder|accuracy|roulette)=.*"
                                + "|.*swarm.*|.*\\.(width|height)=\\d{4,}.*|.*propagation=.*|.*\\.kind=.*"));
    }
}
