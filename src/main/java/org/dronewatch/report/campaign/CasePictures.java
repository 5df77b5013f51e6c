package org.dronewatch.report.campaign;

import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.FlownCase;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.Backdrop;
import org.dronewatch.render.Fineness;
import org.dronewatch.render.Orbit;
import org.dronewatch.render.SitePicture;
import org.dronewatch.render.SiteState;
import org.dronewatch.render.SiteStyle;
import org.dronewatch.render.canvas.FlightStretch;
import org.dronewatch.report.html.Figure;
import org.dronewatch.report.html.Html;
import org.dronewatch.run.AlertResult;
import org.dronewatch.run.DetectionIntervals;
import org.dronewatch.run.RunResult;

/**
 * Pictures of individual cases from above. The colour of each part of a flight shows which sensors detect the drone
 * during that part.
 */
public final class CasePictures {
    private static final int WIDTH = 920;
    private static final int HEIGHT = 552;

    // Approximately the room that the legend takes up.
    private static final int LEGEND_WIDTH = 260;
    private static final int LEGEND_HEIGHT = 180;

    /** How much smaller the site is drawn so that flights begin beside the legend. */
    private static final double ASIDE = 1.3;

    /** Maximum number of flights: more would hide one another. */
    private static final int MOST_FLIGHTS = 8;

    private final CampaignPlan plan;

    /** Pictures of the cases of a campaign. */
    public CasePictures(CampaignPlan plan) {
        this.plan = plan;
    }

    /**
     * Runs a case and writes its picture as PNG.
     *
     * @throws org.dronewatch.setting.InputException when the values of the case are not valid in combination
     */
    public void write(int number, String variant, OutputStream stream) throws IOException {
        stream.write(figure(FlownCase.of(plan, number, variant)).png());
    }

    /** The mark-up of a case's picture: the case is flown again to draw it. */
    String html(int number, String variant) throws IOException {
        Figure figure = figure(FlownCase.of(plan, number, variant));
        return Html.figure(figure.png(), figure.caption());
    }

    private static Figure figure(FlownCase flown) throws IOException {
        RunResult run = flown.run();
        SitePicture picture = new SitePicture(run.settings(), flown.stage());
        List<AlertResult> attacks =
                run.attackAlerts().stream().limit(MOST_FLIGHTS).toList();
        Moment moment = Moment.of(attacks, run.simulated());
        SiteState state = state(flown, picture, attacks, moment.time());
        Orbit above = besideLegend(Orbit.top(picture.frame(), (double) WIDTH / HEIGHT), state);
        Backdrop site =
                picture.backdrop(above, WIDTH, HEIGHT, picture.openRoof(moment.time()), Fineness.FINE, () -> false);
        String caption = flown.name() + ", from above, north up, " + moment.words()
                + ". The colour of the flight path shows which sensors detect the drone; the path is dashed where none"
                + " does.";
        return Figure.of(caption, picture.draw(site, state, SiteStyle.DEFAULT));
    }

    /** A view from above in which the legend, in the upper left corner, covers no flight. */
    private static Orbit besideLegend(Orbit above, SiteState state) {
        double metres = above.metresPerPixel(HEIGHT);
        double left = above.target().x() - metres * (0.5 * WIDTH - LEGEND_WIDTH);
        double top = above.target().y() + metres * (0.5 * HEIGHT - LEGEND_HEIGHT);
        boolean isCovered = state.stretches().stream()
                .flatMap(stretch -> stretch.path().stream())
                .anyMatch(point -> point.x() < left && point.y() > top);
        return isCovered
                ? above.zoomed(ASIDE).at(above.target().plus(new Position(-0.5 * metres * LEGEND_WIDTH, 0.0, 0.0)))
                : above;
    }

    private static SiteState state(FlownCase flown, SitePicture picture, List<AlertResult> attacks, double time) {
        RunResult run = flown.run();
        DetectionIntervals intervals = DetectionIntervals.of(run.events());
        return picture.state(
                        flown.name(),
                        time,
                        (sensor, drone) -> intervals.isDetected(sensor, drone, time),
                        sensor -> flown.pointings().at(sensor, time),
                        Optional.empty(),
                        Optional.empty())
                .withStretches(attacks.stream()
                        .flatMap(attack -> FlightStretch.of(attack.drone(), run, flown.stage()).stream())
                        .toList());
    }

    /**
     * The time of a picture.
     *
     * @param time seconds since the start of the run
     * @param words when that is
     */
    private record Moment(double time, String words) {
        /** The first alert, or else when a drone reaches what is protected, or else the end. */
        static Moment of(List<AlertResult> attacks, double end) {
            OptionalDouble alert = least(attacks.stream().map(AlertResult::time).toList());
            OptionalDouble entered =
                    least(attacks.stream().map(AlertResult::entered).toList());
            String what = alert.isPresent()
                    ? "at the first alert"
                    : entered.isPresent() ? "when the drone reaches what is protected" : "at the end of the run";
            double time = alert.orElse(entered.orElse(end));
            return new Moment(time, String.format(Locale.ROOT, "%s, %.1f s after the start", what, time));
        }

        private static OptionalDouble least(List<OptionalDouble> times) {
            return times.stream()
                    .filter(OptionalDouble::isPresent)
                    .mapToDouble(OptionalDouble::getAsDouble)
                    .min();
        }
    }
}
