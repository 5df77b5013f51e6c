package org.dronewatch.viewer.gallery;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.LinkedHashMap;
import java.util.Map;
import javax.imageio.ImageIO;
import org.dronewatch.scenes.PackagedScene;

/**
 * The pictures of the packaged scenes. They are drawn when the program is built, since drawing them takes seconds.
 *
 * @param byName a picture for each packaged scene, by the scene's name
 */
public record ScenePictures(Map<String, BufferedImage> byName) {
    /** Width of a picture, in pixels. */
    public static final int WIDTH = 480;

    /** Height of a picture, in pixels. */
    public static final int HEIGHT = 300;

    /** Copies the map. */
    public ScenePictures {
        byName = Map.copyOf(byName);
    }

    /** Reads all pictures; not for the event thread. */
    public static ScenePictures read() {
        Map<String, BufferedImage> pictures = new LinkedHashMap<>();
        for (PackagedScene scene : PackagedScene.all()) {
            String file = scene.name() + ".png";
            try (InputStream stream = ScenePictures.class.getResourceAsStream(file)) {
                if (stream == null) {
                    throw new IllegalStateException("no picture of the packaged scene " + scene.name());
                }
                pictures.put(scene.name(), ImageIO.read(stream));
            } catch (IOException e) {
                throw new UncheckedIOException("picture " + file + " of the packaged scenes cannot be read", e);
            }
        }
        return new ScenePictures(pictures);
    }
}
