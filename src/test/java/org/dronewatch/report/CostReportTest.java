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
        int blue = 0;
        for (int x = 0; x < plot.getWidth(); x++) {
            boolean inColumn = false;
            for (int y = 0; y < plot.getHeight(); y++) {
                inColumn |= (plot.getRGB(x, y) & 0xffffff) == 0x1f5fbf;
            }
            blue += inColumn ? 1 : 0;
        }
        // The line goes from the left to the right of the plot.
        assertThat(blue).isGreaterThan(plot.getWidth() / 2);
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
