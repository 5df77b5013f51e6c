package org.dronewatch.report.html;

import java.util.List;
import org.dronewatch.run.Stage;

/**
 * What the report needs of one run besides its result.
 *
 * @param stage its site
 * @param pictures of the site
 */
public record RunView(Stage stage, List<Figure> pictures) {
    /** Keeps its own list. */
    public RunView {
        pictures = List.copyOf(pictures);
    }
}
