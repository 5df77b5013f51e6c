package org.dronewatch.report.labels;

import java.util.List;
import java.util.Locale;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.optics.PictureSettings;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/**
 * A plan for labelled pictures: their cameras and their number.
 *
 * @param cameras ids, in the order of the scene
 * @param samples each pixel is the mean of samples x samples rays
 * @param pictures number of pictures that all cameras take in all runs
 * @param pixels number of pixels of all pictures
 */
public record LabelPlan(List<String> cameras, int samples, long pictures, long pixels) {
    /** Maximum number of pictures that may be written at once. */
    public static final long MOST_PICTURES = 100_000;

    /** Maximum number of pixels of all pictures together. */
    public static final long MOST_PIXELS = 50_000_000_000L;

    /** Looks at the end of the run count in spite of rounding: tolerance as a fraction of the time between them. */
    private static final double ROUNDING = 1e-9;

    private static final double MEGA = 1e6;

    /** Copies the list: later changes by the caller have no effect. */
    public LabelPlan {
        cameras = List.copyOf(cameras);
    }

    /**
     * Plans the pictures that some cameras take.
     *
     * @param option name of the list of cameras in messages, such as {@code --labels}
     * @param chosen ids of cameras
     * @param runs the settings of all runs
     * @throws InputException when a chosen id does not belong to a camera of the scene that takes pictures in visible
     *     light, when a chosen camera is switched off or named twice, or when there are more pictures than {@link
     *     #MOST_PICTURES} or more pixels than {@link #MOST_PIXELS}
     */
    public static LabelPlan of(String option, List<String> chosen, int samples, List<SceneSettings> runs) {
        SceneSettings first = runs.get(0);
        for (int i = 0; i < chosen.size(); i++) {
            check(option, chosen.get(i), first);
            if (chosen.indexOf(chosen.get(i)) < i) {
                throw new InputException(option + " " + chosen.get(i) + ": is given twice");
            }
        }
        List<String> cameras =
                first.sensors().keySet().stream().filter(chosen::contains).toList();
        long pictures = 0;
        double pixels = 0.0;
        for (SceneSettings run : runs) {
            for (String id : cameras) {
                SensorSettings<?> sensor = run.sensors().get(id);
                long looks = looks(run.run().duration(), sensor.rate());
                pictures += looks;
                pixels += (double) looks
                        * sensor.as(PictureSettings.class).orElseThrow().pixels();
            }
        }
        if (pictures > MOST_PICTURES || pixels > MOST_PIXELS) {
            throw new InputException(String.format(
                    Locale.ROOT,
                    "%s: asks for %d pictures with %.0f megapixels in all; at most %d pictures and %.0f megapixels are possible:"
                            + " lower the cameras' rate or resolution, or the run's duration",
                    option,
                    pictures,
                    pixels / MEGA,
                    MOST_PICTURES,
                    MOST_PIXELS / MEGA));
        }
        return new LabelPlan(cameras, samples, pictures, (long) pixels);
    }

    private static void check(String option, String id, SceneSettings settings) {
        List<String> known = settings.enabledSensors().keySet().stream()
                .filter(one -> isCamera(settings.sensors().get(one)))
                .toList();
        if (!known.contains(id)) {
            String why = !settings.sensors().containsKey(id)
                    ? "no such camera"
                    : isCamera(settings.sensors().get(id))
                            ? "is switched off"
                            : "does not take pictures in colour ("
                                    + settings.sensors().get(id).kind() + ")";
            throw new InputException(option + " " + PlainText.value(id) + ": " + why
                    + (known.isEmpty()
                            ? "; no colour camera is switched on"
                            : "; colour cameras that are switched on: " + String.join(", ", known)));
        }
    }

    private static boolean isCamera(SensorSettings<?> sensor) {
        return sensor.as(PictureSettings.class)
                .filter(PictureSettings::seesColour)
                .isPresent();
    }

    private static long looks(double duration, double rate) {
        return (long) Math.floor(duration * rate + ROUNDING) + 1;
    }

    /** The amount of data to be written, in words. */
    public String inWords() {
        return String.format(
                Locale.ROOT,
                "%s taken by %s, %.1f megapixels",
                Counted.of(pictures, "picture"),
                String.join(", ", cameras),
                pixels / MEGA);
    }
}
