package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import org.dronewatch.campaign.CampaignSite;
import org.dronewatch.viewer.Viewer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A case of a campaign in the real window, on a display. Its picture is kept in target/viewer. */
class CaseWindowTest {
    @TempDir
    private Path directory;

    private static <T> T onEventThread(Callable<T> work) throws Exception {
        FutureTask<T> task = new FutureTask<>(work);
        SwingUtilities.invokeAndWait(task);
        return task.get();
    }

    private static Optional<JFrame> frame() {
        return Stream.of(java.awt.Window.getWindows())
                .filter(window -> window.isShowing())
                .filter(JFrame.class::isInstance)
                .map(JFrame.class::cast)
                .findFirst();
    }

    @Test
    @Timeout(value = 2, unit = TimeUnit.MINUTES)
    void aCaseIsShownUnderItsNumberAndItsVariant() throws Exception {
        assumeTrue(Viewer.obstacle().isEmpty(), "needs a display");
        String campaign = CampaignSite.in(directory, CampaignSite.TWO_RANGES).toString();
        StringWriter out = new StringWriter();
        PrintWriter to = new PrintWriter(out, true);
        int[] code = {-1};
        Thread command = new Thread(() -> code[0] = Main.execute(
                to,
                new PrintWriter(new StringWriter(), true),
                "campaign",
                campaign,
                "--case=7",
                "--view",
                "--variant=far"));
        command.start();
        while (onEventThread(() -> frame().isEmpty())) {
            Thread.sleep(50);
        }
        // The run is short; its picture follows.
        Thread.sleep(3000);
        JFrame window = frame().orElseThrow();
        String title = onEventThread(window::getTitle);
        keep(window);
        onEventThread(() -> {
            window.dispatchEvent(new WindowEvent(window, WindowEvent.WINDOW_CLOSING));
            return null;
        });
        command.join();

        assertThat(title).isEqualTo("site, case 7 (far) - dronewatch");
        assertThat(code[0]).isZero();
        assertThat(out.toString())
                .as("the case is also printed")
                .isEqualTo(Program.run("campaign", campaign, "--case=7", "--variant=far")
                        .out());
    }

    private static void keep(JFrame window) throws Exception {
        Rectangle bounds = onEventThread(window::getBounds);
        keep(new Robot().createScreenCapture(bounds));
    }

    private static void keep(java.awt.image.BufferedImage image) throws IOException {
        Path kept = Files.createDirectories(Path.of("target", "viewer"));
        ImageIO.write(image, "png", kept.resolve("case.png").toFile());
    }
}
