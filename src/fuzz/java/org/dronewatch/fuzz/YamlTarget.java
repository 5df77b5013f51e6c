package org.dronewatch.fuzz;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Scene files with mistakes: each is reported with its position, and nothing else happens. */
final class YamlTarget implements FuzzTarget {
    private final List<String> scenes = new ArrayList<>();

    YamlTarget() {
        scenes.addAll(SampleSite.packagedScenes());
        scenes.add(SampleSite.RICH);
        scenes.add(SampleSite.RICH);
    }

    @Override
    public String name() {
        return "yaml";
    }

    @Override
    public FuzzCase generate(Dice dice, long number) {
        String scene = dice.pick(scenes);
        byte[] content = dice.oneIn(5)
                ? ByteMutation.of(scene.getBytes(StandardCharsets.UTF_8), dice)
                : new YamlMutation(scene, dice).mutated().getBytes(StandardCharsets.UTF_8);
        return SampleSite.scene("damaged scene", "", "check", "{}/" + SampleSite.SCENE)
                .with(SampleSite.SCENE, content)
                .with("roof-camera.yaml", SampleSite.roofCamera());
    }

    @Override
    public void judge(FuzzCase input, Path directory) {
        CommandRun[] run = new CommandRun[1];
        Judge.inProportion(20 * input.bytes(), () -> run[0] = Judge.run(directory, input.argumentsIn(directory)));
        for (String line : Messages.mistakes(run[0].err())) {
            if (!isPlaced(line, directory)) {
                throw new Failure("a message with file, line and column", line);
            }
        }
    }

    /** Whether a message states the place: a file with line and column, a file as a whole, or a path of settings. */
    private static boolean isPlaced(String line, Path directory) {
        String text = line.replace(directory + "/", "");
        return text.matches("(?s)[\\w-]+\\.yaml:\\d+(:\\d+)?: .+")
                || text.matches("(?s)scene\\.yaml: (larger|is|cannot|nested|holds).+")
                || text.matches("(?s).*\\b(world|drones|sensors|alert|prices|run|sweep)\\.[\\w.-]+.*")
                || text.matches("(?s).*(model|sensor|drone|scene|setting|sweep|surface).*");
    }
}
