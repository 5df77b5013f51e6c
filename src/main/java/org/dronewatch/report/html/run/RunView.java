package org.dronewatch.report.html.run;

import java.util.List;
import org.dronewatch.report.html.Figure;
import org.dronewatch.run.Stage;

/**
 * The site and images of one run for the report.
 *
 * @param stage the site of the run
 * @param pictures images of the site
 */
public record RunView(Stage stage, List<Figure> pictures) {
    /** Copies the list. */
    public RunView {
        pictures = List.copyOf(pictures);
    }
}
