package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Which links of a built site lead nowhere. */
class SiteLinksTest {
    @TempDir
    private Path site;

    private void write(String name, String html) throws IOException {
        Path file = site.resolve(name);
        Files.createDirectories(file.getParent());
        Files.writeString(file, html);
    }

    private void page(String body) throws IOException {
        write("other.html", "<h2><a class='x' id=\"here\"></a>Here</h2><p id='f&lt;T&gt;(a)'>");
        write("images/a b.png", "");
        write("coverage/org.report.html/index.html", "<p>");
        write("apidocs/index.html", "<a href=\"../index.html\">up</a>");
        write("index.html", "<html><body>" + body + "</body></html>");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "<a href='other.html'>x</a>",
                "<a\n class=\"y\" href=\"other.html#here\">x</a>",
                "<a href=\"other.html#f%3CT%3E(a)\">x</a>",
                "<a href=\"other.html?a=1&amp;b=2#here\">x</a>",
                "<a href=\"#\">x</a>",
                "<h2 id=\"there\"></h2><a href=\"#there\">x</a>",
                "<img alt=\"a\" src=\"./images/a%20b.png\" />",
                "<a href=\"apidocs/\">x</a>",
                "<a href=\"https://example.org/none\">x</a><a href=\"//example.org\">x</a><a href=\"mailto:a@b.c\">x</a>",
                "<!-- <a href=\"none.html\"> --><script>x = '<a href=\"none.html\">';</script>",
                "<p>href=\"none.html\"</p>",
            })
    void aGoodLinkIsLeftAlone(String html) throws IOException {
        page(html);
        assertThat(new SiteLinks(site).broken()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "<a href=\"none.html\">x</a>",
                "<img src=\"images/none.png\">",
                "<img src='images/a b.jpg' alt='x'>",
                "<a id=\"q\" href=\"other.html#nowhere\">x</a>",
                "<a href=\"#nowhere\">x</a>",
                "<a href=\"../outside.html\">x</a>",
                "<a href=\"images/\">a directory without a page</a>",
                "<link href=\"none.css\" rel=\"stylesheet\">",
                "<script src=\"none.js\"></script>",
            })
    void aBrokenLinkIsFound(String html) throws IOException {
        page(html);
        write("../outside.html", "");
        assertThat(new SiteLinks(site).broken()).singleElement().asString().startsWith("index.html: ");
    }
}
