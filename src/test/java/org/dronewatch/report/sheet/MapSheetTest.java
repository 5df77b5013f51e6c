package org.dronewatch.report.sheet;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.coverage.CauseFills;
import org.junit.jupiter.api.Test;

/** The legend of a map, with names of any length. */
class MapSheetTest {
    private static final String NAME =
            "intruder-from-the-north-west-with-a-payload-of-two-and-a-half-kilograms-or-more";
    private static final int SOME = 14;

    private static final FontMetrics METRICS = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB)
            .createGraphics()
            .getFontMetrics(new Font(Font.SANS_SERIF, Font.PLAIN, 15));

    private static BufferedImage image(MapSheet sheet) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        sheet.writePng(bytes);
        return ImageIO.read(new ByteArrayInputStream(bytes.toByteArray()));
    }

    /** The rows of the legend that have dark pixels between two columns of the picture. */
    private static int rows(BufferedImage image, int from, int to) {
        int rows = 0;
        for (int v = 0; v < image.getHeight(); v++) {
            boolean isDark = false;
            for (int u = from; u < to; u++) {
                isDark |= (image.getRGB(u, v) & 0xff) < 0x80;
            }
            rows += isDark ? 1 : 0;
        }
        return rows;
    }

    /** Nothing reaches the edge, and every kind of entry takes more lines than a short one does. */
    @Test
    void longNamesTakeSeveralLinesAndLeaveTheMarginFree() throws IOException {
        FieldGrid grid = new FieldGrid(0, 0, 100, 10, List.of(10.0));
        int before = 0;
        for (String text : List.of("short", "120.5 m: least >= 60.0 s from 240 to 300 deg, " + NAME + " at 120.5 m")) {
            MapSheet sheet = new MapSheet(grid);
            sheet.title(text);
            sheet.line(text);
            sheet.entry(CauseFills.INSIDE, text);
            sheet.sample(Color.RED, text);
            sheet.sampleDashes(text);
            sheet.sample(Color.RED, 2f, text);
            sheet.squareSample(text);
            BufferedImage image = image(sheet);
            assertThat(rows(image, image.getWidth() - 10, image.getWidth())).isZero();
            int rows = rows(image, MapSheet.MAP, image.getWidth());
            assertThat(rows).isGreaterThan(2 * before);
            before = rows;
        }
        assertThat(before).isPositive();
    }

    /** Of several lines in the same places, none hides another, as many as there may usefully be. */
    @Test
    void linesThatLieOnEachOtherAreAllVisible() throws IOException {
        List<Position> square = List.of(
                new Position(-30, -30, 0), new Position(30, -30, 0), new Position(30, 30, 0), new Position(-30, 30, 0));
        for (int lines = 1; lines <= 5; lines++) {
            MapSheet sheet = new MapSheet(new FieldGrid(0, 0, 100, 10, List.of(10.0)));
            List<Color> colours = new ArrayList<>();
            for (int line = 0; line < lines; line++) {
                colours.add(new Color(200, 40 * line, 30));
                sheet.outline(square, new LineLayer(line, lines, colours.get(line)));
            }
            BufferedImage image = image(sheet);
            Set<Integer> acrossAnEdge = IntStream.range(0, MapSheet.MAP / 2)
                    .mapToObj(v -> image.getRGB(MapSheet.MAP / 2, v))
                    .collect(Collectors.toSet());
            assertThat(acrossAnEdge)
                    .as("%d lines", lines)
                    .containsAll(colours.stream().map(Color::getRGB).toList());
        }
    }

    /** Lines of random words fit, and together they are the text; figures at its end stay. */
    @Test
    void linesFitAndLoseNoWord() {
        long seed = 2701;
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < 300; i++) {
            StringBuilder text = new StringBuilder("drone");
            for (int word = random.nextInt(SOME); word >= 0; word--) {
                text.append(' ').append(NAME, 0, 1 + random.nextInt(SOME));
            }
            text.append(" at 120.5 m");
            int most = 200 + random.nextInt(200);
            List<String> lines = LegendText.lines(text.toString(), METRICS, most);
            assertThat(String.join(" ", lines)).as("seed %d", seed).isEqualTo(text.toString());
            assertThat(lines).allMatch(line -> METRICS.stringWidth(line) <= most);
        }
    }

    /** A word that is longer than a line keeps its beginning and its end; no character is split. */
    @Test
    void aWordThatIsTooLongLosesItsMiddle() {
        List<String> lines = LegendText.lines("drone '" + NAME + "' at 120.5 m", METRICS, 330);
        assertThat(lines).hasSize(3).allMatch(line -> METRICS.stringWidth(line) <= 330);
        assertThat(lines.get(1)).startsWith("'intruder-from").contains("\u2026").endsWith("or-more'");
        assertThat(lines.get(2)).isEqualTo("at 120.5 m");
        String drones = "\ud83d\udef8".repeat(60);
        String shown = LegendText.shortened(drones, METRICS, 200);
        assertThat(shown.codePoints().filter(point -> point == 0x1f6f8).count())
                .isEqualTo(shown.codePoints().count() - 1);
        assertThat(LegendText.shortened("m", METRICS, 1)).isEqualTo("m");
    }
}
