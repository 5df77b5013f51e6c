package org.dronewatch.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.AABB;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class GraticuleTest {
    @ParameterizedTest
    @CsvSource({"1, 1", "1.1, 2", "2.3, 5", "6, 10", "0.004, 0.005", "0.01, 0.01"})
    void linesAreAtRoundDegrees(double least, double step) {
        assertThat(Graticule.step(least)).isCloseTo(step, within(1e-12));
    }

    /**
     * The origin is at 45.00 N 10.00 E, whose parallel and meridian cross in the middle; the next are 0.01 and 0.005
     * degrees away.
     */
    @Test
    void linesCrossAtTheirPlaces() {
        BufferedImage image = new BufferedImage(800, 800, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setBackground(Color.WHITE);
        g.clearRect(0, 0, 800, 800);
        Orbit top = Orbit.top(new AABB(-900, -900, -1, 900, 900, 1), 1.0);
        new Graticule(Origin.at(Math.toRadians(45), Math.toRadians(10)), top, 800, 800, 1.0).draw(g);
        g.dispose();
        double metres = top.metresPerPixel(800);
        int east = (int) Math.round(400 + 0.01 * 78_847 / metres);
        int north = (int) Math.round(400 - 0.005 * 111_132 / metres);
        assertThat(isDark(image, 400, 230) && isDark(image, 230, 400)).isTrue();
        assertThat(isDark(image, east, 230)).as("meridian at %s", east).isTrue();
        assertThat(isDark(image, 230, north)).as("parallel at %s", north).isTrue();
        assertThat(isDark(image, (400 + east) / 2, 230)).isFalse();
        assertThat(isDark(image, 230, (400 + north) / 2)).isFalse();
    }

    /** Within a pixel. */
    private static boolean isDark(BufferedImage image, int x, int y) {
        for (int i = -1; i <= 1; i++) {
            for (int k = -1; k <= 1; k++) {
                if ((image.getRGB(x + i, y + k) & 0xff) < 0xf0) {
                    return true;
                }
            }
        }
        return false;
    }
}
