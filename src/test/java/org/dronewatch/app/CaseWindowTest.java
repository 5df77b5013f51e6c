package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.viewer.EventThread.onEventThread;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.Rectangle;
import java.awt.Robot;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import javax.swing.JFrame;
import org.dronewatch.campaign.CampaignSite;
import org.dronewatch.viewer.ShownWindow;
import org.dronewatch.viewer.Viewer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A case of a campaign in the real window, on a display. Its picture is kept in target/viewer. */
class CaseWindowTest {
    @TempDir
    private Path directory;

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
        ShownWindow.awaitFinished();
        // Its picture follows.
        Thread.sleep(3000);
        JFrame window = onEventThread(() -> ShownWindow.frame().orElseThrow());
        String title = onEventThread(window::getTitle);
        keep(window);
        ShownWindow.close();
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
