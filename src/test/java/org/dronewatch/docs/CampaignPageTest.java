package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dronewatch.app.Main;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;

/**
 * The figures of the page about campaigns are those of its campaign, which takes half a minute: it is run only with
 * {@code -Ddronewatch.docs=all}, and {@code =write} writes the rose again.
 */
@EnabledIfSystemProperty(named = "dronewatch.docs", matches = "all|write")
class CampaignPageTest {
    private static final Path ROSE = Path.of("src", "site", "images", "attack-rose.svg");
    private static final String STYLE = "<style>text { font: 12px sans-serif; fill: #20262e; }</style>";

    @TempDir
    private Path directory;

    @Test
    void figuresAndRoseAreThoseOfTheCampaign() throws IOException {
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        Path results = directory.resolve("vendors");
        int code = Main.execute(
                new PrintWriter(out, true),
                new PrintWriter(err, true),
                "campaign",
                "scenes/two-radars.campaign.yaml",
                "--out=" + results);
        assertThat(code).as(err.toString()).isZero();

        String rose = rose(Files.readString(results.resolve("report.html")));
        if ("write".equals(System.getProperty("dronewatch.docs"))) {
            Files.writeString(ROSE, rose);
        }
        assertThat(Files.readString(ROSE)).isEqualTo(rose);
        List<String> page = Files.readAllLines(Path.of("src", "site", "markdown", "campaign.md")).stream()
                .map(String::strip)
                .toList();
        assertThat(out.toString().lines().map(String::strip).filter(line -> !line.matches("(detected|alerted): .*")))
                .allMatch(page::contains);
    }

    /** The drawing of the report as a file on a white ground. */
    private static String rose(String report) {
        int begin = report.indexOf("<svg", report.indexOf("By direction of attack"));
        int end = report.indexOf("</svg>", begin) + "</svg>".length();
        String svg = report.substring(begin, end);
        int inside = svg.indexOf('>') + 1;
        return svg.substring(0, inside) + "\n" + STYLE + "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>"
                + svg.substring(inside) + "\n";
    }
}
