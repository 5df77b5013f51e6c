package org.dronewatch.app;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import org.dronewatch.analysis.CalibratedEntry;
import org.dronewatch.analysis.Calibration;
import org.dronewatch.app.console.Notes;
import org.dronewatch.app.option.GivenOption;
import org.dronewatch.app.option.JsonOption;
import org.dronewatch.app.option.SceneChoice;
import org.dronewatch.drone.Drone;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.report.file.WholeFile;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scenario.SweptValue;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.SoundTracing;
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
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** Fits a sensor's threshold to a known range. */
@Command(
        name = "calibrate",
        mixinStandardHelpOptions = true,
        description =
                "Fits the threshold of a microphone or a radio receiver, or the number of pixels that a camera needs on a"
                        + " drone, to a known range,"
                        + " the greatest at which the sensor detects a drone with a clear line of sight. Writes the sensor as a"
                        + " file that scenes refer to with 'use'. Air, background noise, rain and light are those of the scene;"
                        + " its models and noise sources are left out. The file states the range and the conditions.",
        footer = {
            "",
            "Examples:",
            "  dronewatch calibrate multi-sensor --sensor microphone --drone quadrotor --range 300m --out mic.yaml",
            "  dronewatch calibrate acoustic-range --sensor microphone --drone quadrotor --range 150m --run 2 --out mic.yaml"
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
            description = "Range from the sensor to the drone, which flies straight towards the sensor at the sensor's"
                    + " height: 1 m to 100 km.")
    private String range;

    @Option(
            names = "--probability",
            defaultValue = "0.5",
            paramLabel = "P",
            description = "Minimum probability with which a look at this range detects the drone; 0.5 by default.")
    private String probability;

    @Option(
            names = "--run",
            defaultValue = "0",
            paramLabel = "N",
            description = "Index of the run of a sweep whose conditions are used, counted from 0; 0 by default.")
    private int run;

    @Option(
            names = "--out",
            required = true,
            paramLabel = "FILE",
            description =
                    "File to write, NAME.yaml; a scene file in the same directory refers to it as 'use: NAME'. An existing"
                            + " file is replaced only if 'calibrate' wrote it.")
    private String out;

    @Mixin
    private JsonOption json = new JsonOption();

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        WholeFile target = target();
        double metres = value("--range", range, Quantity.LENGTH, Calibration.NEAREST, Calibration.FARTHEST);
        double least = value("--probability", probability, Quantity.RATIO, Double.MIN_NORMAL, 1.0);
        Scene scene = choice.create();
        SceneRunner runner = choice.runner(scene);
        runner.notes(Notes.of(spec));
        SceneSettings settings = SceneChoice.settingsOfRun(runner, run);
        known("--sensor", "sensor", sensor, settings.sensors().keySet());
        known("--drone", "drone", drone, settings.individualDrones().keySet());
        runner.adviseOnConditions();
        Drone flying = runner.stage(settings).dronesAt(0.0).stream()
                .filter(one -> one.id().equals(drone))
                .findFirst()
                .orElseThrow();
        warnOfNoiseSources(settings);
        Calibration fit = fit(settings, flying, metres, least);
        Optional<String> swept = settings.sweep()
                .map(sweep -> "run " + run + " of the sweep, " + new SweptValue(settings, sweep).text());
        byte[] text = new CalibratedEntry(scene.name(), swept, settings, sensor, drone, fit, metres, least)
                .text(scene.directory(), target.path())
                .getBytes(StandardCharsets.UTF_8);
        target.write(stream -> stream.write(text));
        swept.ifPresent(which -> Notes.of(spec)
                .accept("fitted for " + PlainText.line(which) + (isAsked("--run") ? "" : "; --run chooses another")));
        json.print(() -> toJson(fit), tables -> CalibratedEntry.lines(fit).forEach(tables::println));
        Notes.of(spec).accept("sensor in " + PlainText.value(out));
        return 0;
    }

    private ObjectNode toJson(Calibration fit) {
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        root.put("sensor", sensor);
        root.put("drone", drone);
        root.put("setting", fit.scale().setting());
        root.put("unit", fit.scale().quantity().unit());
        root.put("value", Numbers.rounded(fit.threshold()));
        root.put("range_m", Numbers.rounded(fit.range()));
        ArrayNode ranges = root.putArray("ranges");
        new TreeMap<>(fit.ranges()).forEach((value, metres) -> {
            ObjectNode one = ranges.addObject();
            one.put("value", Numbers.rounded(value));
            // Some whole numbers are not reached at any range.
            one.put("range_m", metres.isNaN() ? null : Numbers.rounded(metres));
        });
        root.put("file", out);
        return root;
    }

    private void warnOfNoiseSources(SceneSettings settings) {
        boolean listens = settings.sensors().get(sensor).as(SoundTracing.class).isPresent();
        if (listens && !settings.world().noiseSources().isEmpty()) {
            spec.commandLine()
                    .getErr()
                    .println("warning: world.noiseSources and all models are left out: the only noise is"
                            + " world.backgroundNoise");
        }
    }

    private boolean isAsked(String option) {
        return spec.commandLine().getParseResult().hasMatchedOption(option);
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
            throw new InputException(asked + "is the scene file itself; choose another file");
        }
        return target.replacingOnly(CalibratedEntry.FIRST_LINE, "'calibrate'");
    }

    private static void known(String option, String what, String id, Set<String> all) {
        if (!all.contains(id)) {
            throw new InputException(GivenOption.words(option, id) + ": no such " + what + "; "
                    + (all.isEmpty() ? "the scene has none" : Spelling.closestMatches(id, all)));
        }
    }

    private static double value(String option, String text, Quantity quantity, double from, double to) {
        String given = GivenOption.words(option, text) + ": ";
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
