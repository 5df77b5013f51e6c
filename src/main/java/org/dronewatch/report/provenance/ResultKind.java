package org.dronewatch.report.provenance;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/**
 * The kind of command that results come from, recognised by files that are included only in results of this kind.
 * Different commands write some files under the same names, such as {@code provenance.json}, so the results of two
 * commands in one directory would partly replace each other.
 */
public enum ResultKind {
    /** Results of {@code run}. */
    RUN("a run", "result.json"),
    /** Results of {@code coverage}. */
    COVERAGE("'coverage'", "coverage.json"),
    /** Results of {@code route}. */
    ROUTE("'route'", "route.json"),
    /** Results of {@code place}. */
    PLACE("'place'", "place.json"),
    /** Results of {@code campaign}, {@code compare} or {@code merge}. */
    CAMPAIGN("a campaign", "plan.json", "campaign.json");

    private final String words;
    private final List<String> signs;

    ResultKind(String words, String... signs) {
        this.words = words;
        this.signs = List.of(signs);
    }

    /** The file that all results of this kind have and no other results do. */
    public String sign() {
        return signs.get(0);
    }

    /**
     * Makes sure that a directory holds no results of another kind.
     *
     * @param target the directory, which need not exist
     * @throws InputException when it holds such results
     */
    public void checkAlone(Path target) {
        other(target).ifPresent(found -> {
            throw new InputException("output directory " + PlainText.value(target) + " holds the results of " + found
                    + ", some of which would be replaced: choose another directory");
        });
    }

    /** Whether a directory, which need not exist, holds no results of another kind. */
    boolean isAlone(Path target) {
        return other(target).isEmpty();
    }

    /** Which results of another kind a directory holds, in words. */
    private Optional<String> other(Path target) {
        for (ResultKind other : values()) {
            for (String sign : other.signs) {
                if (other != this && Files.isRegularFile(target.resolve(sign))) {
                    return Optional.of(other.words + " (" + sign + ")");
                }
            }
        }
        return Optional.empty();
    }
}
