package org.dronewatch.report.placement;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.report.html.Figure;

/**
 * The part of a report that depends on the objective.
 *
 * @param verdict sentences in plain text that follow those common to all objectives; may be empty
 * @param pictures pictures by the names of their files
 * @param sections sections in the order in which they are shown
 * @param scope the limitations of these results, in sentences
 */
public record PlaceChapter(String verdict, Map<String, Figure> pictures, List<Section> sections, List<String> scope) {
    /**
     * A section.
     *
     * @param title plain text
     * @param html mark-up
     */
    public record Section(String title, String html) {}

    /** Copies the collections. */
    public PlaceChapter {
        pictures = Collections.unmodifiableMap(new LinkedHashMap<>(pictures));
        sections = List.copyOf(sections);
        scope = List.copyOf(scope);
    }
}
