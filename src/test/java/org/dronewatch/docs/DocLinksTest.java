package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.dronewatch.docs.SitePages.Link;
import org.dronewatch.docs.SitePages.Text;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Every link, anchor and picture in the pages leads somewhere, as a code hosting site shows them and in the built site.
 */
class DocLinksTest {
    private static final Path PROJECT = Path.of("").toAbsolutePath();

    @TempDir
    private Path directory;

    private static Text text(Path page) throws IOException {
        return new Text(Files.readString(PROJECT.resolve(page)));
    }

    private static String problem(Path page, Link link) throws IOException {
        Path file = link.file().isEmpty()
                ? PROJECT.resolve(page)
                : PROJECT.resolve(page).resolveSibling(link.file()).normalize();
        if (!file.startsWith(PROJECT) || !Files.isRegularFile(file)) {
            return "no such file";
        }
        // On a disk that knows no upper and lower case, a link that a code hosting site does not find is found.
        if (!file.equals(file.toRealPath())) {
            return "is called " + file.toRealPath();
        }
        boolean anchored = !link.fragment().isEmpty() && file.toString().endsWith(".md");
        return anchored && !text(file).headings().containsKey(link.fragment().substring(1)) ? "no such heading" : "";
    }

    @Test
    void linksLeadSomewhere() throws IOException {
        List<String> broken = new ArrayList<>();
        int seen = 0;
        for (Path page : SitePages.sources(PROJECT)) {
            for (Link link : text(page).links()) {
                if (!link.isOutside()) {
                    seen++;
                    String problem = problem(page, link);
                    if (!problem.isEmpty()) {
                        broken.add(page + ": " + link.to() + ": " + problem);
                    }
                }
            }
        }
        assertThat(broken).isEmpty();
        assertThat(seen).as("links, of which there are many").isGreaterThan(100);
    }

    @Test
    void theSiteCanBeWritten() throws IOException {
        new SitePages(PROJECT, directory).write();
        assertThat(directory.resolve("markdown/index.md")).exists();
    }

    @Test
    void everyPageIsInTheMenu() throws IOException {
        String menu = Files.readString(PROJECT.resolve("src/site/site.xml"));
        new SitePages(PROJECT, directory).write();
        TreeSet<String> missing = new TreeSet<>();
        try (Stream<Path> pages = Files.list(directory.resolve("markdown"))) {
            pages.map(page -> page.getFileName().toString().replace(".md", ".html"))
                    .filter(page -> !menu.contains("href=\"" + page + "\""))
                    .forEach(missing::add);
        }
        assertThat(missing).isEmpty();
    }
}
