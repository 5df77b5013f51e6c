package org.dronewatch.fuzz;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** Names in files and on the command line that would steer a terminal: whatever is printed about them is plain text. */
final class TextTarget implements FuzzTarget {
    private static final int KINDS = 6;
    /** All commands but {@code costs}, which alone is busy for minutes. */
    private static final List<String> COMMANDS =
            List.of("list", "run", "check", "render", "coverage", "bench", "models", "view");

    private static final List<String> OPTIONS = List.of(
            "--set",
            "--out",
            "--seed",
            "--threads",
            "--camera",
            "--time",
            "--view",
            "--side",
            "--height",
            "--cells",
            "--rays",
            "--width",
            "--passes",
            "--traversal",
            "--hits",
            "--real-time",
            "--nonsense");

    /** Options that name what is written. */
    private static final Set<String> WRITTEN = Set.of("--out", "--hits", "--rays");

    @Override
    public String name() {
        return "text";
    }

    @Override
    public FuzzCase generate(Dice dice, long number) {
        return switch ((int) (number % KINDS)) {
            case 0 -> ids(dice);
            case 1 -> materials(dice);
            case 2 -> arguments(dice);
            case 3 -> fileName(dice);
            case 4 -> values(dice);
            default -> catalogue(dice);
        };
    }

    private static FuzzCase ids(Dice dice) {
        String scene = "world: {models: [{file: site.obj, upAxis: z}]}\n"
                + "drones: {" + YamlMutation.quoted(NastyValues.name(dice))
                + ": {model: drone.obj, flight: {kind: hover, position: [9, 9, 15]}}}\n"
                + "sensors: {" + YamlMutation.quoted(NastyValues.name(dice))
                + ": {kind: camera, position: [0, 0, 12], width: 32, height: 24}}\n"
                + "run: {duration: 0.1}\n";
        return SampleSite.scene("names of drones and sensors", scene, dice.pick("check", "run"), "{}/scene.yaml");
    }

    private static FuzzCase materials(Dice dice) {
        String scene = "world: {models: [{file: site.obj, upAxis: z}, model.obj]}\n"
                + "sensors: {ear: {kind: acoustic, position: [0, 0, 12]}}\n";
        String model = "mtllib " + oneLine(dice) + "\no " + oneLine(dice) + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl "
                + oneLine(dice) + "\nf 1 2 3\n" + (dice.oneIn(3) ? "f 1 2 " + oneLine(dice) + "\n" : "");
        return SampleSite.scene("names of materials", scene, "check", "{}/scene.yaml")
                .with("model.obj", model)
                .with("model.mtl", "newmtl " + oneLine(dice) + "\nKd " + oneLine(dice) + "\n");
    }

    private static String oneLine(Dice dice) {
        return dice.oneIn(4) ? "model.mtl" : NastyValues.name(dice).replaceAll("[\r\n\0]", "_");
    }

    private static FuzzCase arguments(Dice dice) {
        List<String> arguments = new ArrayList<>();
        arguments.add(dice.oneIn(6) ? argument(dice) : dice.pick(COMMANDS));
        if (!dice.oneIn(4)) {
            arguments.add(dice.oneIn(3) ? argument(dice) : "{}/no-such-scene.yaml");
        }
        for (int i = dice.below(4); i > 0; i--) {
            String option = dice.pick(OPTIONS);
            arguments.add(option);
            String value = argument(dice);
            arguments.add(WRITTEN.contains(option) ? "{}/" + value.replace("..", "_") : value);
        }
        return SampleSite.scene("command line", "world: {models: [site.obj]}\n", arguments.toArray(String[]::new));
    }

    /** An argument that names no existing file; no results must be written outside the directory of the case. */
    private static String argument(Dice dice) {
        String name = NastyValues.name(dice).replace("\0", "_");
        return dice.oneIn(2) ? name + "\u001b[31m" : "{}/" + name;
    }

    private static FuzzCase fileName(Dice dice) {
        String name = NastyValues.name(dice).replaceAll("[\0/\uD800-\uDFFF]", "_");
        String fitting = name.substring(0, Math.min(60, name.length())) + ".yaml";
        return SampleSite.scene("name of a scene file", "", "check", "{}/" + fitting)
                .with(fitting, "world: {models: [site.obj], nonsense: 1}\n");
    }

    private static FuzzCase values(Dice dice) {
        String name = YamlMutation.quoted(NastyValues.name(dice));
        String scene = dice.pick(
                "world: {models: [" + name + "]}\n",
                "world: {models: [site.obj]}\nsensors: {s: {use: " + name + ", position: [0, 0, 1]}}\n",
                "world: {models: [site.obj]}\nsensors: {s: {kind: " + name + ", position: [0, 0, 1]}}\n",
                "world: {models: [site.obj], surfaces: {defaultSurface: " + name + "}}\n",
                "world: {models: [site.obj], surfaces: {materials: {" + name + ": solid}}}\n",
                "world: {models: [site.obj], rain: " + name + "}\n",
                "world: {models: [site.obj]}\n" + name + ": {}\n",
                "world: {models: [site.obj]}\nsweep: {parameter: " + name + ", values: [1, 2]}\n",
                "world: {models: [site.obj]}\nprices: {currency: " + name + ", sensors: {" + name + ": 1}}\n",
                "world: {models: [site.obj]}\ndrones: {d: {model: drone.obj, sound: " + name
                        + ", flight: {kind: hover, position: [0, 0, 1]}}}\n");
        return SampleSite.scene("names in settings", scene, "check", "{}/scene.yaml");
    }

    private static FuzzCase catalogue(Dice dice) {
        String name = YamlMutation.quoted(NastyValues.name(dice));
        String entry = SampleSite.roofCamera()
                .replaceFirst(
                        "(?m)^" + dice.pick("title", "source", "basis", "note", "coverage", "  kind", "  width")
                                + ": .*",
                        "X");
        String scene = "world: {models: [site.obj]}\nsensors: {s: {use: mine, position: [0, 0, 1]}}\n";
        return SampleSite.scene("a sensor of one's own", scene, "check", "{}/scene.yaml")
                .with("mine.yaml", entry.replace("X", "title: " + name + "\nnote: " + name));
    }

    @Override
    public void judge(FuzzCase input, Path directory) {
        List<String> arguments = new ArrayList<>(List.of(input.argumentsIn(directory)));
        if (arguments.get(0).equals("run") && !arguments.contains("--out")) {
            arguments.addAll(List.of("--out", directory.resolve("out").toString()));
        }
        CommandRun run = CommandRun.of(arguments.toArray(String[]::new));
        // 3: a window was asked for, and there is no display.
        Judge.check(run.code() == 3 ? new CommandRun(2, run.out(), run.err()) : run, directory);
    }
}
