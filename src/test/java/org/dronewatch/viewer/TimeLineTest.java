package org.dronewatch.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JScrollPane;
import javax.swing.UIManager;
import org.dronewatch.run.RunInfo;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.viewer.part.Scaled;
import org.dronewatch.viewer.run.Playback;
import org.dronewatch.viewer.run.RecordedRun;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class TimeLineTest {
    private static final String LONG = "a-radar-on-the-highest-mast-of-the-north-eastern-corner-by-gate";

    @TempDir
    private Path directory;

    private final Playback playback = new Playback();
    private final TimeLine line = new TimeLine(playback);

    @BeforeEach
    void showManySensors() throws Exception {
        StringBuilder sensors = new StringBuilder();
        for (int i = 0; i < 40; i++) {
            sensors.append(String.format("  r%02d: {use: spotterrf-c550, position: [%d, 0, 144]}%n", i, i));
        }
        sensors.append("  ").append(LONG).append(": {use: spotterrf-c550, position: [50, 0, 144]}\n");
        sensors.append("  off: {use: spotterrf-c550, position: [60, 0, 144], enabled: false}\n");
        Path file = directory.resolve("many.yaml");
        Files.writeString(
                file, "world: {models: [packaged:hill.obj]}\nsensors:\n" + sensors + "run: {duration: 30 s}\n");
        SceneRunner runner = new SceneRunner(new SceneFile(file));
        SceneSettings settings = runner.settings();
        RecordedRun run = new RecordedRun(new RunInfo(0, 1, settings), runner.stage(settings));
        playback.show(run);
        line.setSize(800, 900);
        line.update();
    }

    @AfterEach
    void restoreFont() {
        UIManager.put("Label.font", null);
    }

    @Test
    void namesTakeAsMuchRoomAsTheyNeedWithinLimitsAndNeverReachTheBars() {
        FontMetrics metrics = line.getFontMetrics(Scaled.font(0.9));
        assertThat(line.label("r07")).isEqualTo("r07");
        String cut = line.label(LONG);
        assertThat(cut).startsWith("a-radar-on").endsWith("\u2026").hasSizeLessThan(LONG.length());
        for (String shown : List.of("r07", cut)) {
            assertThat(metrics.stringWidth(shown)).isLessThan(line.left());
        }
        assertThat(line.left()).isLessThan((int) (0.25 * 800) + 40);
        assertThat(line.xOf(0.0)).isEqualTo(line.left());

        line.setSize(4000, 900);
        assertThat(line.label(LONG)).as("where there is room").isEqualTo(LONG);
    }

    @Test
    void theTipOverANameIsAllOfIt() {
        int y = (int) (line.yOf(40) + 2);
        assertThat(line.getToolTipText(new MouseEvent(line, 0, 0, 0, 5, y, 0, false)))
                .isEqualTo(LONG);
        assertThat(line.getToolTipText(new MouseEvent(line, 0, 0, 0, (int) line.xOf(15.0), y, 0, false)))
                .isEqualTo(LONG + ", 15.00 s");
    }

    /** What cannot detect anything needs no room. */
    @Test
    void aDisabledSensorHasNoRow() {
        int below = (int) (line.yOf(41) + 2);
        assertThat(line.getToolTipText(new MouseEvent(line, 0, 0, 0, 5, below, 0, false)))
                .as("beyond the last row, the last one counts")
                .isEqualTo(LONG);
    }

    @Test
    void rowsStayLegibleAndScrollWhileTheAxisStaysInSight() {
        FontMetrics metrics = line.getFontMetrics(Scaled.font(0.9));
        assertThat(line.rowHeight()).isGreaterThanOrEqualTo(metrics.getHeight());
        JScrollPane scrolling = line.scrolling();
        scrolling.setSize(800, 150);
        scrolling.doLayout();
        scrolling.getViewport().doLayout();
        assertThat(line.getHeight()).isGreaterThan(400);
        line.scrollRectToVisible(new java.awt.Rectangle(0, 300, 10, 10));
        BufferedImage image = new BufferedImage(800, 150, BufferedImage.TYPE_INT_RGB);
        scrolling.paint(image.getGraphics());

        int ink = 0;
        for (int row = 150 - metrics.getHeight(); row < 150; row++) {
            for (int column = line.left() + 30; column < 760; column++) {
                ink += (image.getRGB(column, row) & 255) < 150 ? 1 : 0;
            }
        }
        assertThat(ink).as("numbers of the axis at the lower edge").isGreaterThan(50);
    }

    @Test
    void textFollowsTheFontOfTheLookAndFeel() {
        double before = line.rowHeight();
        int left = line.left();
        UIManager.put("Label.font", new Font(Font.SANS_SERIF, Font.PLAIN, 30));
        assertThat(line.rowHeight()).isGreaterThan(1.9 * before);
        assertThat(line.left()).isGreaterThanOrEqualTo(left);
        assertThat(Scaled.font(0.5).getSize2D()).isEqualTo(15f);
    }
}
