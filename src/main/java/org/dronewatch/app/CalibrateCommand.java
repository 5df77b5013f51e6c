package org.dronewatch.app;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.Callable;
import org.dronewatch.analysis.CalibratedEntry;
import org.dronewatch.analysis.Calibration;
import org.dronewatch.drone.Drone;
import org.dronewatch.report.WholeFile;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingText;
import org.dronewatch.setting.Spelling;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Fits a sensor's threshold to a known range. */
@Command(
        name = "calibrate",
        mixinStandardHelpOptions = true,
        description =
                "Fits the threshold of a microphone or a radio receiver, or the pixel count of a camera, so that in"
                        + " free sight a range is the greatest at which it detects a drone, and writes the sensor as a file that"
                        + " scenes take by 'use'. Air, noise, rain and light are those of the scene; its models are left out.",
        footer = {
            "",
            "Example:",
            "  dronewatch calibrate multi-sensor --sensor microphone --drone quadrotor --range 300m --out mic.yaml"
        })
final class CalibrateCommand implements Callable<Integer> {
    private static final String ENDING = ".yaml";

    @Mixin
    private SceneChoice choice;

    @Option(names = "--sensor", required = true, paramLabel = "ID", description = "Sensor of the scene.")
    private String sensor;

    @Option(names = "--drone", required = true, paramLabel = "ID", description = "Drone of the scene.")
    private String drone;

    @Option(
            names = "--range",
            required = true,
            paramLabel = "R",
            description = "Range from the sensor to the drone, which flies straight towards it at its height: 1 m to"
                    + " 100 km.")
    private String range;

    @Option(
            names = "--probability",
            defaultValue = "0.5",
            paramLabel = "P",
            description = "Minimum probability with which a look at this range detects the drone; 0.5 by default.")
    private String probability;

    @Option(
            names = "--out",
            required = true,
            paramLabel = "NAME.yaml",
            description = "File to write; a scene file in the same directory takes it by 'use: NAME'.")
    private String out;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        WholeFile target = target();
        double metres = value("--range", range, Quantity.LENGTH, Calibration.NEAREST, Calibration.FARTHEST);
        double least = value("--probability", probability, Quantity.RATIO, Double.MIN_NORMAL, 1.0);
        Scene scene = choice.create();
        SceneRunner runner = choice.runner(scene);
        runner.notes(spec.commandLine().getErr()::println);
        SceneSettings settings = runner.settingsOfRuns().get(0);
        known("--sensor", "sensor", sensor, settings.sensors().keySet());
        known("--drone", "drone", drone, settings.fliers().keySet());
        Drone flying = runner.stage(settings).dronesAt(0.0).stream()
                .filter(one -> one.id().equals(drone))
                .findFirst()
                .orElseThrow();
        Calibration fit = fit(settings, flying, metres, least);
        byte[] text = CalibratedEntry.text(
                        scene.name(), settings, sensor, drone, fit, metres, least, scene.directory(), target.path())
                .getBytes(StandardCharsets.UTF_8);
        target.write(stream -> stream.write(text));
        CalibratedEntry.lines(fit).forEach(spec.commandLine().getOut()::println);
        spec.commandLine().getErr().println("sensor in " + PlainText.value(out));
        return 0;
    }

    private Calibration fit(SceneSettings settings, Drone flying, double metres, double least) {
        try {
            return Calibration.of(settings, flying, sensor, metres, least);
        } catch (InputException e) {
            throw new InputException("--range " + PlainText.value(range) + ": " + e.getMessage(), e);
        }
    }

    private WholeFile target() {
        String asked = "--out " + PlainText.value(out) + ": ";
        if (!out.endsWith(ENDING)) {
            throw new InputException(asked + "must end in " + ENDING);
        }
        WholeFile target = new WholeFile("--out", out);
        String name = String.valueOf(target.path().getFileName());
        if (!name.matches("[A-Za-z0-9_-]{1,64}\\.yaml")) {
            throw new InputException(asked + "the name before " + ENDING
                    + " must be 1 to 64 letters, digits, '-' or '_', so that 'use' can name it");
        }
        if (choice.isSceneFile(target.path())) {
            throw new InputException(asked + "is the scene file itself; name another file");
        }
        return target;
    }

    private static void known(String option, String what, String id, Set<String> all) {
        if (!all.contains(id)) {
            throw new InputException(option + " " + PlainText.value(id) + ": no such " + what + "; "
                    + (all.isEmpty() ? "the scene has none" : Spelling.nearestAre(id, all)));
        }
    }

    private static double value(String option, String text, Quantity quantity, double from, double to) {
        String given = option + " " + PlainText.value(text) + ": ";
        double value;
        try {
            value = (double) SettingText.parse(double.class, quantity, text);
        } catch (IllegalArgumentException e) {
            throw new InputException(given + e.getMessage(), e);
        }
        if (!(value >= from && value <= to)) {
            String limits = from < 1.0 ? "above 0 and at most %s" : "from " + quantity.inWords(from) + " to %s";
            throw new InputException(given + "must be " + String.format(Locale.ROOT, limits, quantity.inWords(to)));
        }
        return value;
    }
}
