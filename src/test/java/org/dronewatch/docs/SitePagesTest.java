package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Pages become those of the site, and what leads nowhere is found. */
class SitePagesTest {
    @TempDir
    private Path directory;

    private Path project;
    private Path site;

    @BeforeEach
    void layOut() throws IOException {
        project = directory.resolve("project");
        site = directory.resolve("site");
        write("CHANGELOG.md", "# Changelog\n");
        write("models/README.md", "# Models\n");
        write("scenes/a.yaml", "a: 1\n");
        write("src/site/site.xml", "<site/>");
        write("src/site/resources/css/site.css", "img { max-width: 100% }\n");
        write("src/site/resources/js/search.js", "// not read\n");
        write("src/site/images/b.png", "not read");
        write("src/site/markdown/guide.md", "# Guide\n\n## Who, and `what`?\n\n## Limits\n\n## Limits\n");
        write("README.md", "# Project\n");
    }

    private void write(String file, String text) throws IOException {
        Path target = project.resolve(file);
        Files.createDirectories(target.getParent());
        Files.writeString(target, text);
    }

    private String written(String page, String name, String text) throws IOException {
        write(page, text);
        new SitePages(project, site).write();
        return Files.readString(site.resolve("markdown").resolve(name));
    }

    @Test
    void pagesAndPicturesStandSideBySide() throws IOException {
        String page = written(
                "src/site/markdown/c.md",
                "c.md",
                "[g](guide.md#limits-1) ![b](../images/b.png) [a](../../../scenes/a.yaml) [m](../../../models/README.md)"
                        + " [w](https://example.org/x.md) [h](#here)\n");
        assertThat(page)
                .isEqualTo("[g](guide.md#limits-1) ![b](images/b.png) [a](scenes/a.yaml) [m](models.md)"
                        + " [w](https://example.org/x.md) [h](#here)\n");
        assertThat(site.resolve("resources/images/b.png")).exists();
        assertThat(site.resolve("resources/scenes/a.yaml")).hasContent("a: 1\n");
        assertThat(site.resolve("site.xml")).exists();
        assertThat(site.resolve("resources/css/site.css")).hasContent("img { max-width: 100% }");
    }

    @Test
    void everySectionCanBeSearchedByItsWords() throws IOException {
        write(
                "src/site/markdown/c.md",
                "# C\n\nA **`b`** [\"c\"](guide.md), `<ele>`.\n\n## D \\ e\n\n| f | g |\n|---|---|\n| h | i |\n");
        new SitePages(project, site).write();

        assertThat(Files.readString(site.resolve("resources/js/pages.js")))
                .startsWith("window.dronewatchPages = [\n")
                .endsWith("];\n")
                .contains(
                        "{page: \"c.html\", anchor: \"c\", title: \"C\", heading: \"C\", text: \"A b \\\"c\\\", <ele> .\"},\n")
                .contains("{page: \"c.html\", anchor: \"d--e\", title: \"C\", heading: \"D \\\\ e\","
                        + " text: \"f g h i\"},\n")
                .contains("page: \"guide.html\", anchor: \"limits-1\"")
                .doesNotContain("changelog.html");
    }

    @Test
    void theReadmeIsAPageOfTheSite() throws IOException {
        String page =
                written("README.md", "readme.md", "![b](src/site/images/b.png) [g](src/site/markdown/guide.md)\n");
        assertThat(page).isEqualTo("![b](images/b.png) [g](guide.md)\n");
    }

    @Test
    void headingsHaveTheAnchorsOfACodeHostingSite() throws IOException {
        assertThat(written("README.md", "guide.md", "[a](CHANGELOG.md)\n"))
                .contains("## <a id=\"who-and-what\"></a>Who, and `what`?")
                .contains("## <a id=\"limits\"></a>Limits\n\n## <a id=\"limits-1\"></a>Limits");
    }

    @Test
    void anchorsAndLinksMayBeInOneHeading() throws IOException {
        String page =
                written("README.md", "readme.md", "# See [the guide](src/site/markdown/guide.md) first\n\n## End\n");
        assertThat(page)
                .isEqualTo(
                        "# <a id=\"see-the-guide-first\"></a>See [the guide](guide.md) first\n\n## <a id=\"end\"></a>End\n");
    }

    @Test
    void codeIsNeitherLinkNorHeading() throws IOException {
        String text = "`[a](no.md)` is code, ``so is `[b](no.md)` this``\n\n```sh\n# no heading\n[c](no.md)\n```\n\n"
                + "    # nor this\n    [d](no.md)\n\n`e`\nends.\n";
        assertThat(written("README.md", "readme.md", text)).isEqualTo(text);
    }

    @Test
    void codeAtTheBeginningOfALineHidesNoLink() throws IOException {
        String page = written(
                "README.md", "readme.md", "Text.\n\n`some: longer code` and [a](scenes/a.yaml)\n[x](CHANGELOG.md)\n");
        assertThat(page).contains("(changelog.md)");
    }

    @Test
    void aLinkToNowhereEndsTheBuild() throws IOException {
        for (String link : List.of("none.md", "../scenes/a.yaml", "scenes", "src/site/images/none.png")) {
            write("README.md", "text ![x](" + link + ")\n");
            assertThatThrownBy(() -> new SitePages(project, site).write())
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("README.md")
                    .hasMessageContaining(link);
        }
    }
}
