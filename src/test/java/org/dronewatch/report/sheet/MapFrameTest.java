package org.dronewatch.report.sheet;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The scale and the arrow on a map, and the labels beside them. */
class MapFrameTest {
    private static final int SIZE = 1000;

    /** Wherever a label should be, it ends on the map, and on no pixel that the frame has drawn. */
    @ParameterizedTest
    @ValueSource(doubles = {20.0, 99.0, 400.0, 2400.0})
    void labelsCoverNeither(double side) {
        BufferedImage map = new BufferedImage(SIZE, SIZE, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = map.createGraphics();
        MapFrame.draw(g, SIZE, side);
        g.dispose();
        Rectangle all = new Rectangle(SIZE, SIZE);
        for (int u = 0; u <= SIZE - 40; u += 8) {
            for (int v = 0; v <= SIZE - 24; v += 8) {
                Rectangle wanted = new Rectangle(u, v, 40, 24);
                Rectangle label = MapFrame.beside(wanted, SIZE, side);

                assertThat(all.contains(label)).isTrue();
                assertThat(isFree(map, label))
                        .as("%s moved to %s", wanted, label)
                        .isTrue();
                if (isFree(map, wanted)) {
                    assertThat(label).isEqualTo(wanted);
                }
            }
        }
    }

    private static boolean isFree(BufferedImage map, Rectangle box) {
        for (int u = box.x; u < box.x + box.width; u++) {
            for (int v = box.y; v < box.y + box.height; v++) {
                if (map.getRGB(u, v) != Color.BLACK.getRGB()) {
                    return false;
                }
            }
        }
        return true;
    }
}
