package org.dronewatch.viewer;

import static org.dronewatch.viewer.EventThread.onEventThread;

import java.awt.Robot;
import java.awt.Window;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;

/** What the screen shows of a window, kept in {@code target/viewer} for people to look at. */
final class KeptPicture {
    /** A window may be painted on the screen a little later than in memory, ms. */
    private static final long PAINTED = 300;

    private KeptPicture() {}

    /**
     * Keeps a picture of a window.
     *
     * @param name of the file, without {@code .png}
     */
    static void of(Window window, String name) throws Exception {
        Thread.sleep(PAINTED);
        Path kept = Files.createDirectories(Path.of("target", "viewer"));
        ImageIO.write(
                new Robot().createScreenCapture(onEventThread(window::getBounds)),
                "png",
                kept.resolve(name + ".png").toFile());
    }
}
