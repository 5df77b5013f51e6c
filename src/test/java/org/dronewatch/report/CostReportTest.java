package org.dronewatch.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import javax.imageio.ImageIO;
import org.dronewatch.bench.CostCurves;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CostReportTest {
    private static final CostCurves CURVES = new CostCurves(
            "build",
            "Building",
            "triangles",
            "time [s]",
            List.of(new CostCurves.Line("a tree", List.of(1000.0, 4000.0), List.of(0.001, 0.0045))));

    @TempDir
    Path directory;

    @Test
    void aTableAndAPlotWithTheLine() throws IOException {
        CostReport.write(directory, () -> List.of(CURVES));

        assertThat(Files.readAllLines(directory.resolve("build.csv")))
                .containsExactly("line,triangles,time [s]", "a tree,1000,0.001", "a tree,4000,0.0045");
        BufferedImage plot = ImageIO.read(directory.resolve("build.png").toFile());
        // The line goes from the left to the right of the plot, and from its bottom to its top.
        assertThat(blue(plot, true)).isGreaterThan(plot.getWidth() / 2);
        assertThat(blue(plot, false)).isGreaterThan(plot.getHeight() / 2);
    }

    /** Fifty bytes and fifty-five are not a cliff. */
    @Test
    void aCostThatHardlyChangesIsShownFromZero() throws IOException {
        CostCurves.Line line = new CostCurves.Line("bytes", List.of(1000.0, 4000.0), List.of(50.0, 55.0));
        CostReport.write(
                directory, () -> List.of(new CostCurves("memory", "Memory", "triangles", "bytes", List.of(line))));

        BufferedImage plot = ImageIO.read(directory.resolve("memory.png").toFile());
        assertThat(blue(plot, true)).isGreaterThan(plot.getWidth() / 2);
        assertThat(blue(plot, false)).isLessThan(plot.getHeight() / 4);
    }

    /** In how many columns, or rows, of a plot there is something of the colour of its first line. */
    private static int blue(BufferedImage plot, boolean columns) {
        int across = columns ? plot.getWidth() : plot.getHeight();
        int along = columns ? plot.getHeight() : plot.getWidth();
        int found = 0;
        for (int i = 0; i < across; i++) {
            boolean any = false;
            for (int j = 0; j < along; j++) {
                any |= (plot.getRGB(columns ? i : j, columns ? j : i) & 0xffffff) == 0x1f5fbf;
            }
            found += any ? 1 : 0;
        }
        return found;
    }

    @Test
    void nothingIsMeasuredForADirectoryThatCannotBeWritten() throws IOException {
        Path file = Files.createFile(directory.resolve("file"));
        AtomicBoolean measured = new AtomicBoolean();
        assertThatThrownBy(() -> CostReport.write(file, () -> {
                    measured.set(true);
                    return List.of(CURVES);
                }))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("is a file");
        assertThat(measured).isFalse();
    }
}
