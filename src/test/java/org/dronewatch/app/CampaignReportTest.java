package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.assertj.core.data.Offset;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.campaign.CampaignSite;
import org.dronewatch.report.html.ReportPage;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The report of a campaign says what its files say. */
class CampaignReportTest {
    private static final List<String> OUTCOMES = List.of("detected", "alerted", "in_time");

    @TempDir
    private static Path directory;

    private static Path file;
    private static String text;
    private static Document page;
    private static JsonNode json;

    @BeforeAll
    static void run() throws IOException {
        CampaignSite.in(directory, CampaignSite.TWO_RANGES);
        Files.move(directory.resolve("site.yaml"), directory.resolve("R&D site.yaml"));
        file = Files.writeString(
                directory.resolve("R&D.campaign.yaml"),
                CampaignSite.TWO_RANGES.replace("site.yaml", "'R&D site.yaml'").replace("350 m", "300 m"));
        Outcome outcome = Program.run("campaign", file.toString(), "--out=" + directory.resolve("out"));
        assertThat(outcome.code()).as(outcome.err()).isZero();
        text = Files.readString(directory.resolve("out/report.html"));
        page = ReportPage.parsed(text);
        json = JsonMapper.builder()
                .build()
                .readTree(directory.resolve("out/campaign.json").toFile());
    }

    private static String words(JsonNode share) {
        return String.format(
                Locale.ROOT,
                "%.1f %% (%.1f to %.1f)",
                100.0 * share.get("share").asDouble(),
                100.0 * share.get("low").asDouble(),
                100.0 * share.get("high").asDouble());
    }

    @Test
    void theNumbersAreThoseOfTheFile() {
        List<String> cells = ReportPage.texts(page, "td");
        for (String variant : List.of("near", "far")) {
            JsonNode one = json.get("variants").get(variant);
            OUTCOMES.forEach(outcome -> assertThat(cells).contains(words(one.get(outcome))));
            for (JsonNode sector : one.get("by_bearing")) {
                JsonNode inTime = sector.get("in_time");
                assertThat(cells)
                        .contains(
                                inTime.isNull()
                                        ? "-"
                                        : inTime.get("k").asInt() + " of "
                                                + inTime.get("n").asInt());
            }
            assertThat(cells)
                    .contains(String.format(
                            Locale.ROOT, "%.1f", one.get("warning_s").get("p95").asDouble()));
        }
        JsonNode pair = json.get("pairs").get(2);
        assertThat(ReportPage.texts(page, "li"))
                .singleElement()
                .asString()
                .contains("only with near in 0 of 60 cases, only with far in "
                        + pair.get("only_b").asInt() + ".");
    }

    @Test
    void theFirstParagraphSaysWhichIsBetterAndWhetherThatIsMoreThanChance() {
        JsonNode variants = json.get("variants");
        JsonNode pair = json.get("pairs").get(2);
        String verdict = ReportPage.texts(page, "p").get(0);

        assertThat(pair.get("p").asDouble()).isBetween(0.0155, 0.016);
        assertThat(verdict)
                .contains("In 60 attacks, the alert is in time in "
                        + words(variants.get("far").get("in_time")) + " with far, in "
                        + words(variants.get("near").get("in_time")) + " with near.")
                .contains(String.format(
                        Locale.ROOT,
                        "The better variant is far: the difference between far and near, %+.1f percentage points"
                                + " (%+.1f to %+.1f), is more than chance can explain (p = 0.016).",
                        -100.0 * pair.get("difference").asDouble(),
                        -100.0 * pair.get("high").asDouble(),
                        -100.0 * pair.get("low").asDouble()));
    }

    /** Of a scale of 820 for 100 %. */
    @Test
    void barsAndWhiskersAreAsLongAsTheSharesSay() {
        NodeList bars = page.getElementsByTagName("rect");
        List<String> names = List.of("near", "far");

        assertThat(bars.getLength()).isEqualTo(names.size());
        for (int i = 0; i < bars.getLength(); i++) {
            JsonNode share = json.get("variants").get(names.get(i)).get("in_time");
            Element bar = (Element) bars.item(i);
            assertThat(Double.parseDouble(bar.getAttribute("width")))
                    .isCloseTo(820.0 * share.get("share").asDouble(), Offset.offset(0.06));
            assertThat(text)
                    .contains(String.format(
                            Locale.ROOT,
                            "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\"",
                            12.0 + 820.0 * share.get("low").asDouble(),
                            29.0 + 44.0 * i,
                            12.0 + 820.0 * share.get("high").asDouble()));
        }
    }

    /** Found among the rows of the table, and repeated by the command that the report states. */
    @Test
    void theWorstCaseCanBeRunAgain() throws IOException {
        List<String> header = new ArrayList<>();
        int worst = -1;
        double least = Double.POSITIVE_INFINITY;
        for (String line : Files.readAllLines(directory.resolve("out/runs.csv"))) {
            List<String> row = List.of(line.split(",", -1));
            if (header.isEmpty()) {
                header.addAll(row);
            } else if (row.get(1).equals("near")) {
                String detected = row.get(header.indexOf("first_detected_s"));
                String warning = row.get(header.indexOf("warning_s"));
                double value = detected.isEmpty()
                        ? Double.parseDouble(row.get(header.indexOf("closest_m"))) - 1e6
                        : Double.parseDouble(warning);
                if (value < least) {
                    least = value;
                    worst = Integer.parseInt(row.get(0));
                }
            }
        }
        Matcher command = Pattern.compile("dronewatch campaign \"(.*)\" --case " + worst)
                .matcher(String.join("\n", ReportPage.texts(page, "td")));

        assertThat(ReportPage.texts(page, "h3")).contains("near: case " + worst);
        assertThat(command.find()).isTrue();
        Outcome again = Program.run("campaign", command.group(1), "--case", Integer.toString(worst));
        assertThat(again.code()).as(again.err()).isZero();
        String near = again.out()
                .lines()
                .filter(line -> line.startsWith("near: "))
                .findFirst()
                .orElseThrow()
                .substring("near: ".length());
        assertThat(text).contains(near.substring(1));
    }

    /** The worst case of each variant, and the first case that decides with both. */
    @Test
    void theCasesThatMatterAreDrawnAndCanBeWatched() throws IOException {
        NodeList pictures = page.getElementsByTagName("img");
        List<String> captions = ReportPage.texts(page, "figcaption");
        int deciding = json.get("pairs").get(2).get("cases").get(0).asInt();

        assertThat(pictures.getLength()).isEqualTo(4);
        for (int i = 0; i < pictures.getLength(); i++) {
            String data = ((Element) pictures.item(i)).getAttribute("src");
            BufferedImage image = ImageIO.read(
                    new ByteArrayInputStream(Base64.getDecoder().decode(data.substring(data.indexOf(',') + 1))));
            assertThat(image.getWidth()).isEqualTo(920);
        }
        assertThat(captions.get(0)).startsWith("R&D site, case " + deciding + " (near), from above, north up, ");
        assertThat(captions.get(1))
                .startsWith("R&D site, case " + deciding + " (far), from above, north up, at the first alert, ");
        assertThat(ReportPage.texts(page, "h3")).contains("Case " + deciding + ": the alert is in time only with far");
        assertThat(ReportPage.texts(page, "td"))
                .anyMatch(cell -> cell.endsWith("R&D.campaign.yaml\" --case " + deciding + " --variant far --view"));
    }

    /** As rows of the table say: of those that were missed, none came closer. */
    @Test
    void theWorstCaseIsTheOneThatComesClosest() throws IOException {
        List<String> lines = Files.readAllLines(directory.resolve("out/runs.csv"));
        List<String> header = List.of(lines.get(0).split(",", -1));
        double least = lines.stream()
                .skip(1)
                .map(line -> List.of(line.split(",", -1)))
                .filter(row -> row.get(1).equals("near")
                        && row.get(header.indexOf("alert_s")).isEmpty())
                .mapToDouble(row -> Double.parseDouble(row.get(header.indexOf("closest_m"))))
                .min()
                .orElseThrow();

        assertThat(least).isPositive();
        assertThat(text)
                .contains(String.format(
                        Locale.ROOT, "Never detected; no alert; came within %.1f m of what is protected.", least));
    }

    @Test
    void whatComesFromFilesIsNotMarkUp() {
        assertThat(text).contains("R&amp;D site.yaml").doesNotContain("R&D");
        assertThat(ReportPage.texts(page, "h1")).containsExactly("R&D site.yaml: campaign");
    }
}
