package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.function.Consumer;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** A change that the eye sees is found in a picture of the pages; other letters and rounding are none. */
class LikenessTest {
    private BufferedImage picture;

    @BeforeEach
    void read() throws IOException {
        picture = DocPictures.read(DocPictures.file("glider"));
    }

    private BufferedImage with(Consumer<Graphics2D> change) {
        BufferedImage changed = new BufferedImage(picture.getWidth(), picture.getHeight(), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = changed.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.drawImage(picture, 0, 0, null);
        change.accept(g);
        g.dispose();
        return changed;
    }

    private static void write(Graphics2D g, String font) {
        g.setColor(Color.DARK_GRAY);
        g.setFont(new Font(font, Font.PLAIN, 14));
        for (int line = 0; line < 4; line++) {
            g.drawString("detects from 100 m on, not before", 600, 620 + 20 * line);
        }
    }

    @ParameterizedTest
    @EnumSource(Likeness.class)
    void theSamePictureIsAlike(Likeness likeness) {
        assertThat(likeness.difference(picture, with(g -> {}))).isEmpty();
    }

    @ParameterizedTest
    @EnumSource(Likeness.class)
    void roundingIsNoDifference(Likeness likeness) {
        BufferedImage rounded = with(g -> {});
        for (int y = 0; y < rounded.getHeight(); y++) {
            for (int x = y % 2; x < rounded.getWidth(); x += 2) {
                rounded.setRGB(x, y, rounded.getRGB(x, y) ^ 0x020202);
            }
        }
        assertThat(likeness.difference(picture, rounded)).isEmpty();
    }

    @Test
    void lettersOfAnotherFontAreNoDifferenceWhereThereIsAnother() {
        BufferedImage one = with(g -> write(g, Font.SANS_SERIF));
        BufferedImage another = with(g -> write(g, Font.MONOSPACED));
        assertThat(Likeness.OTHER_FONT.difference(one, another)).isEmpty();
        assertThat(Likeness.SAME_FONT.difference(one, another)).isPresent();
    }

    @Test
    void aLineMoreIsADifference() {
        BufferedImage changed = with(g -> {
            g.setColor(Color.RED);
            g.drawLine(300, 250, 600, 300);
        });
        assertThat(Likeness.SAME_FONT.difference(picture, changed)).isPresent();
    }

    @Test
    void aSymbolInAnotherColourIsADifference() {
        BufferedImage changed = with(g -> {
            g.setColor(Color.BLUE);
            g.fillOval(860, 290, 48, 48);
        });
        assertThat(Likeness.SAME_FONT.difference(picture, changed)).isPresent();
    }

    @ParameterizedTest
    @EnumSource(Likeness.class)
    void anotherPlaceIsADifference(Likeness likeness) {
        BufferedImage moved = with(g -> g.drawImage(picture, 0, 25, null));
        assertThat(likeness.difference(picture, moved)).isPresent();
    }

    @ParameterizedTest
    @EnumSource(Likeness.class)
    void anotherSizeIsADifference(Likeness likeness) {
        assertThat(likeness.difference(picture, picture.getSubimage(0, 0, picture.getWidth() - 1, picture.getHeight())))
                .hasValueSatisfying(text -> assertThat(text).contains("1279 x 800"));
    }
}
