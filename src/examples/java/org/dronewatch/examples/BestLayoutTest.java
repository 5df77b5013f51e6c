package org.dronewatch.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BestLayoutTest {
    private static final Path PAGE = Path.of("src/site/markdown/placement.md");
    private static final String CANDIDATES = "name,cost,kind,exclusive,fixed";
    private static final String VALUES = "row,candidate,value,weight";
    private static final double UNDETECTED = 60.0;

    @TempDir
    private Path directory;

    /** Writes the two files that the page shows side by side. */
    private void writeThePagesFiles() throws IOException {
        List<String> page = Files.readAllLines(PAGE);
        int head = page.indexOf("    " + CANDIDATES + "        " + VALUES);
        assertThat(head)
                .as("the line of %s that names the columns of both files", PAGE)
                .isNotNegative();
        List<String> left = new ArrayList<>();
        List<String> right = new ArrayList<>();
        for (int i = head; page.get(i).startsWith("    "); i++) {
            int column = page.get(head).indexOf(VALUES);
            String line = page.get(i);
            left.add(line.substring(0, column).strip());
            right.add(line.substring(column).strip());
        }
        left.removeIf(String::isEmpty);
        Files.write(directory.resolve("candidates.csv"), left);
        Files.write(directory.resolve("values.csv"), right);
    }

    private BestLayout best(double budget) {
        return BestLayout.of(directory.resolve("candidates.csv"), directory.resolve("values.csv"), budget);
    }

    /** C is fixed, and A and B exclude each other: there are three layouts. */
    @Test
    void theFilesOfThePageHaveTheLayoutThatIsStatedThere() throws IOException {
        writeThePagesFiles();

        BestLayout best = best(1000.0);
        assertThat(best.names()).containsExactly("A", "C");
        assertThat(best.result().value()).isCloseTo(0.15 * 2 + 0.5 * 3, within(1e-12));
        assertThat(best.result().cost()).isEqualTo(500.0);
        assertThat(best.result().complete()).isTrue();
        assertThat(Files.readString(PAGE)).contains("0.15 · 2 + 0.5 · 3 = 1.8");

        assertThat(best(450.0).names()).containsExactly("C");
        assertThat(best(450.0).result().value()).isCloseTo(0.15 * 50 + 0.5 * 50, within(1e-12));
    }

    /** All 1,024 layouts of ten candidates are tried. */
    @Test
    void noOtherLayoutIsBetter() throws IOException {
        Random random = new Random(3);
        System.out.println("BestLayoutTest: seed 3");
        double[] costs = random.doubles(10, 50.0, 200.0).toArray();
        double[] weights = random.doubles(20, 0.1, 1.0).toArray();
        double[][] impacts = new double[20][];
        List<String> candidates = new ArrayList<>(List.of("name,cost"));
        for (int candidate = 0; candidate < 10; candidate++) {
            candidates.add("c" + candidate + "," + costs[candidate]);
        }
        List<String> values = new ArrayList<>(List.of(VALUES));
        for (int row = 0; row < 20; row++) {
            impacts[row] = random.doubles(10, 0.0, UNDETECTED).toArray();
            values.add("r" + row + ",," + UNDETECTED + "," + weights[row]);
            for (int candidate = 0; candidate < 10; candidate++) {
                values.add("r" + row + ",c" + candidate + "," + impacts[row][candidate] + "," + weights[row]);
            }
        }
        Files.write(directory.resolve("candidates.csv"), candidates);
        Files.write(directory.resolve("values.csv"), values);

        for (double budget : new double[] {100.0, 300.0, 500.0}) {
            double least = Double.POSITIVE_INFINITY;
            for (int layout = 0; layout < 1 << 10; layout++) {
                if (sum(costs, layout) <= budget) {
                    least = Math.min(least, impact(impacts, weights, layout));
                }
            }
            BestLayout best = best(budget);
            assertThat(best.result().value()).as("budget %s", budget).isCloseTo(least, within(1e-9));
            int chosen =
                    best.result().chosen().stream().mapToInt(one -> 1 << one).sum();
            assertThat(impact(impacts, weights, chosen)).isCloseTo(least, within(1e-9));
            assertThat(sum(costs, chosen)).isCloseTo(best.result().cost(), within(1e-9));
            assertThat(best.result().cost()).isLessThanOrEqualTo(budget);
        }
    }

    /** The sum of the costs of those candidates whose bits are set. */
    private static double sum(double[] costs, int layout) {
        double sum = 0.0;
        for (int candidate = 0; candidate < costs.length; candidate++) {
            sum += (layout >> candidate & 1) * costs[candidate];
        }
        return sum;
    }

    private static double impact(double[][] impacts, double[] weights, int layout) {
        double sum = 0.0;
        for (int row = 0; row < impacts.length; row++) {
            double least = UNDETECTED;
            for (int candidate = 0; candidate < impacts[row].length; candidate++) {
                least = (layout >> candidate & 1) == 1 ? Math.min(least, impacts[row][candidate]) : least;
            }
            sum += weights[row] * least;
        }
        return sum;
    }
}
