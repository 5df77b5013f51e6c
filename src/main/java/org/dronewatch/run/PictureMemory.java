package org.dronewatch.run;

import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Imaging;
import org.dronewatch.setting.InputException;

/**
 * Checks whether the depth buffers of a scene's cameras fit on the heap: each stores, for every pixel, the distance to
 * the nearest surface of the site.
 */
public final class PictureMemory {
    private static final int MEBIBYTE = 1 << 20;

    private PictureMemory() {}

    /**
     * Checks that the depth buffers fit, before anything is created.
     *
     * @param most maximum size of the heap, bytes
     * @throws InputException when there are too many pixels
     */
    public static void check(SceneSettings settings, long most) {
        long pixels = settings.enabledSensors().values().stream()
                .flatMap(sensor -> sensor.as(Imaging.class).stream())
                .mapToLong(Imaging::pixels)
                .sum();
        long bytes = pixels * Float.BYTES;
        if (bytes > most) {
            throw new InputException("sensors: pictures of " + pixels + " px need " + bytes / MEBIBYTE
                    + " MiB, more than the " + most / MEBIBYTE
                    + " MiB that Java may use: give Java more (-Xmx), or the cameras fewer pixels");
        }
    }
}
