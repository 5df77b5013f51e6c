package org.dronewatch.viewer;

import java.awt.BorderLayout;
import java.awt.GridLayout;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.Action;
import javax.swing.JPanel;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.Orbit;
import org.dronewatch.render.canvas.Cut;
import org.dronewatch.viewer.part.Scaled;
import org.dronewatch.viewer.run.ViewedRun;

/** The site view with the bar that selects viewpoint and cut. */
final class SiteSection extends JPanel {
    private static final long serialVersionUID = 1L;

    /** The fraction of the site's extent that a close-up view shows. */
    private static final double NEAR = 0.12;

    private static final double NEAREST = 4.0;

    /** Space between two views, in pixels of a normal screen. */
    private static final int BETWEEN = 3;

    private final WorldPanel world;
    private final WorldBar bar;
    private final JPanel views = new JPanel(new GridLayout(1, 0, Scaled.px(BETWEEN), 0));
    private transient ViewedRun viewed;
    private transient Runnable focus = () -> {};

    /**
     * An empty section.
     *
     * @param threads number of threads that paint the site
     * @param failed receives what went wrong
     */
    SiteSection(int threads, Consumer<Throwable> failed) {
        super(new BorderLayout());
        world = new WorldPanel("dronewatch", threads, failed);
        bar = new WorldBar(world, views().toArray(Action[]::new));
        add(bar, BorderLayout.NORTH);
        views.add(world);
        add(views, BorderLayout.CENTER);
    }

    /** Sets what turns the view to the selection. */
    void onFocus(Runnable target) {
        focus = target;
    }

    /** The actions that select a view, created anew for each bar and menu. */
    List<Action> views() {
        return List.of(
                view(
                        "Orbit",
                        "Shows all sensors and flights in perspective",
                        '1',
                        box -> Orbit.about(box, world.aspect())),
                view("From above", "A plan with north up", '2', box -> Orbit.top(box, world.aspect())),
                view(
                        "From the side",
                        "A horizontal view from the east",
                        '3',
                        box -> Orbit.side(box, world.aspect(), 0.5 * Math.PI)),
                ViewerActions.action(
                        "Focus",
                        "Zooms in on the selected sensor or drone",
                        ViewerActions.key('F'),
                        () -> focus.run()));
    }

    private Action view(String name, String explanation, char key, Function<AABB, Orbit> from) {
        return ViewerActions.action(name, explanation, ViewerActions.key(key), () -> {
            if (viewed != null) {
                world.move(from.apply(viewed.picture().frame()));
            }
        });
    }

    /** Shows another run's site; the first from the default viewpoint, others from the current one. */
    void show(ViewedRun next, Optional<Cut> cut) {
        Orbit from = viewed == null ? Orbit.about(next.picture().frame(), world.aspect()) : world.orbit();
        viewed = next;
        bar.show(next.stage().world().bounds(), cut);
        world.show(next.picture(), from, cut);
    }

    /** Shows a close-up of a place, m; there must be a run. */
    void focusOn(Position at) {
        double high = Math.max(NEAREST, NEAR * viewed.picture().interest().diagonal());
        world.move(world.orbit().at(at).showing(high));
    }

    /** Shows another view of equal size on the right of the site's own, or none. */
    void showBeside(Optional<WorldPanel> other) {
        while (views.getComponentCount() > 1) {
            views.remove(1);
        }
        other.ifPresent(views::add);
        views.revalidate();
        views.repaint();
    }

    WorldPanel world() {
        return world;
    }
}
