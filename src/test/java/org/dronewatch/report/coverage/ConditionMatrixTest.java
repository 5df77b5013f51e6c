package org.dronewatch.report.coverage;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldRequest;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.analysis.survey.ConditionCoverage;
import org.dronewatch.analysis.survey.FieldCondition;
import org.dronewatch.analysis.survey.FieldSurvey;
import org.dronewatch.analysis.survey.HeightSummary;
import org.dronewatch.parallel.Workers;
import org.dronewatch.report.coverage.table.ConditionTable;
import org.dronewatch.report.coverage.table.CoverageInputs;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The picture of the coverage under conditions: the colour of each cell is its fraction. */
class ConditionMatrixTest {
    private static final FieldGrid GRID = new FieldGrid(0, 0, 300, 20, List.of(2.0, 20.0, 40.0));
    private static final String LONG = "a condition with a name of forty letters";
    private static final int WIDTH = 190;
    private static final int HEIGHT = 58;
    private static final int LEFT = 114;
    private static final int TOP = 120;

    @TempDir
    private static Path directory;

    private static List<ConditionCoverage> conditions;
    private static BufferedImage picture;

    private static FieldRequest request(String... disabled) {
        SceneRunner runner = new SceneRunner(new SceneFile(directory.resolve("site.yaml")));
        for (String one : disabled) {
            runner.set("sensors." + one + ".enabled", "false");
        }
        var stage = runner.stage(runner.settings());
        return new FieldRequest(
                runner.settings(),
                stage,
                FieldSite.DRONE,
                GRID,
                Course.all(runner.settings().enabledSensors(), DetectionField.droneOf(stage, FieldSite.DRONE)),
                FieldCoverage.Choice.BEST,
                FieldTerms.ONE_LOOK,
                0.5);
    }

    @BeforeAll
    static void draw() throws IOException {
        FieldSite.in(
                directory,
                FieldSite.ROUND + FieldSite.ROUND.replace("round", "low").replace("150", "60"));
        FieldRequest asItIs = request();
        try (Workers workers = new Workers(2)) {
            conditions = workers.call(() -> FieldSurvey.of(
                            asItIs,
                            List.of(
                                    new FieldCondition(LONG, () -> request("round")),
                                    new FieldCondition("nothing", () -> request("round", "low"))),
                            cells -> {},
                            () -> {}))
                    .conditions();
        }
        picture = picture(conditions);
    }

    private static BufferedImage picture(List<ConditionCoverage> shown) throws IOException {
        CoverageInputs inputs = new CoverageInputs(
                "a scene with a very long name, ".repeat(9),
                FieldSite.DRONE,
                "best",
                0.5,
                FieldTerms.ONE_LOOK,
                Optional.empty(),
                Optional.empty());
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        new ConditionMatrix(shown, inputs).writePng(bytes);
        return ImageIO.read(new ByteArrayInputStream(bytes.toByteArray()));
    }

    /** From dark to light by the fraction that is covered: columns are conditions, the highest height is on top. */
    @Test
    void theColourOfACellIsItsFraction() {
        List<Double> shares = new ArrayList<>();
        for (int column = 0; column < 3; column++) {
            for (int height = 0; height < 3; height++) {
                ConditionCoverage.Height its = conditions.get(column).heights().get(height);
                double share = (double) its.summary().covered() / its.summary().known();
                Color expected = new Color(
                        (int) Math.round(0x2c + share * (0xff - 0x2c)),
                        (int) Math.round(0x4a + share * (0xf3 - 0x4a)),
                        (int) Math.round(0x86 + share * (0xc4 - 0x86)));
                int left = LEFT + column * WIDTH;
                int top = TOP + (2 - height) * HEIGHT;
                assertThat(new Color(picture.getRGB(left + 2, top + 2))).isEqualTo(expected);
                assertThat(new Color(picture.getRGB(left + WIDTH - 5, top + HEIGHT - 5)))
                        .isEqualTo(expected);
                int ink = 0;
                Color written = share < 0.5 ? Color.WHITE : Color.BLACK;
                for (int u = left; u < left + WIDTH - 2; u++) {
                    for (int v = top; v < top + HEIGHT - 2; v++) {
                        ink += picture.getRGB(u, v) == written.getRGB() ? 1 : 0;
                    }
                }
                assertThat(ink).as("numbers that can be read").isPositive();
                shares.add(share);
            }
        }
        assertThat(shares.subList(0, 3)).allMatch(share -> share > 0.5);
        assertThat(shares.subList(3, 6)).allMatch(share -> share > 0.05 && share < 0.5);
        assertThat(shares.subList(6, 9)).containsOnly(0.0);
    }

    /** Where nothing is known, nothing is said about the coverage. */
    @Test
    void whatIsUnknownIsNotZero() throws IOException {
        ConditionCoverage.Height none = conditions.get(0).heights().get(0);
        HeightSummary summary = none.summary();
        HeightSummary unknown = new HeightSummary(
                summary.height(),
                summary.cells(),
                0,
                0,
                0,
                0.0,
                Map.of(),
                Map.of(),
                new int[] {0, 0},
                Map.of(),
                Map.of(),
                Optional.empty());
        ConditionCoverage nothing =
                new ConditionCoverage("", List.of(new ConditionCoverage.Height(unknown, 0, 0, Map.of())));
        BufferedImage grey = picture(List.of(nothing));
        assertThat(new Color(grey.getRGB(LEFT + 2, TOP + 2))).isEqualTo(new Color(0xe4e4e4));
        assertThat(ConditionTable.lines(List.of(nothing, nothing), 0.5).get(2)).endsWith("  -");
    }

    /** Names that are too long stay in their column, and the title in the picture. */
    @Test
    void longNamesAreShortened() {
        int named = 0;
        for (int v = 0; v < TOP; v++) {
            for (int u : new int[] {LEFT + WIDTH, LEFT + 2 * WIDTH, picture.getWidth() - 8}) {
                boolean isTitle = u < picture.getWidth() - 8 && v < 80;
                assertThat(isTitle || picture.getRGB(u, v) == -1)
                        .as("%d, %d", u, v)
                        .isTrue();
            }
            for (int u = LEFT + WIDTH; u < LEFT + 2 * WIDTH; u++) {
                named += v > 90 && picture.getRGB(u, v) != -1 ? 1 : 0;
            }
        }
        assertThat(named).isPositive();
    }
}
