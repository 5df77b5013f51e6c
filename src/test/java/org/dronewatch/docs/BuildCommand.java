package org.dronewatch.docs;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A command of Maven, or a script of the project, that a page shows in a block or within its text.
 *
 * @param page the page's file
 * @param words its words, as a shell parts them, the name of the program first
 */
record BuildCommand(Path page, List<String> words) {
    private static final Pattern COMMAND = Pattern.compile("(?m)(?:^ {4}(?<block>(?:mvn|scripts/\\S+)(?: [^\\n]*)?)$"
            + "|`(?<text>(?:mvn|scripts/[\\w.-]+)(?: [^`\\n]*)?)`)");
    private static final Path CHANGES = Path.of("CHANGELOG.md");

    /** The commands of all pages but the list of changes, which also names what there once was. */
    static List<BuildCommand> all() throws IOException {
        Set<BuildCommand> commands = new LinkedHashSet<>();
        for (Path page : SitePages.sources(Path.of("").toAbsolutePath())) {
            Matcher found = COMMAND.matcher(page.equals(CHANGES) ? "" : Files.readString(page));
            while (found.find()) {
                String line = found.group("block") == null ? found.group("text") : found.group("block");
                commands.add(of(page, line));
            }
        }
        return new ArrayList<>(commands);
    }

    static BuildCommand of(Path page, String line) {
        return new BuildCommand(page, PageCommand.words(line));
    }

    boolean isMaven() {
        return words.get(0).equals("mvn");
    }

    @Override
    public String toString() {
        return page + ": " + String.join(" ", words);
    }
}
