package org.dronewatch.viewer;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import org.dronewatch.viewer.beside.ComparisonPanel;
import org.dronewatch.viewer.beside.OtherRun;
import org.dronewatch.viewer.part.Latest;
import org.dronewatch.viewer.run.RecordedRun;
import org.dronewatch.viewer.run.Recording;
import org.dronewatch.viewer.run.ViewedRun;

/**
 * Another run beside the one that is shown: its site, at the same time and from the same viewpoint, and what differs.
 * It can be one that was recorded before, another of the same sweep, or one that is still to come. For the event
 * thread.
 */
final class Comparing {
    /** The name of the run from which a scene was changed and run again. */
    static final String BEFORE = "before the change";

    private final SiteSection site;
    private final ComparisonPanel panel;
    private final WorldPanel other;
    private final Latest preparing;
    private final Consumer<String> messages;
    private final List<OtherRun> kept = new ArrayList<>();
    private Optional<Awaited> awaited = Optional.empty();
    private Optional<ViewedRun> viewed = Optional.empty();
    private Optional<OtherRun> asked = Optional.empty();
    private Optional<String> selected = Optional.empty();
    private double time;

    /** The time up to which the other run had been simulated when it was last drawn, s. */
    private double reached;

    /** A run that another thread will record. */
    private record Awaited(String name, Recording recording) {}

    /**
     * Compares nothing yet.
     *
     * @param threads number of threads that paint the other site
     * @param panel chooses the other run
     * @param selection receives the sensor or drone that was clicked on in the other site
     * @param messages receives texts for the status line
     * @param failed receives what went wrong
     */
    Comparing(
            SiteSection site,
            ComparisonPanel panel,
            int threads,
            Consumer<String> selection,
            Consumer<String> messages,
            Consumer<Throwable> failed) {
        this.site = site;
        this.panel = panel;
        this.messages = messages;
        this.other = new WorldPanel("dronewatch-other", threads, failed);
        this.preparing = new Latest("dronewatch-beside", 1, failed);
        other.getAccessibleContext().setAccessibleName("site of the other run");
        other.onSelection(selection);
        other.onHint(messages);
        other.onViewChanged(() -> follow(site.world(), other));
        site.world().onViewChanged(this::viewChanged);
        panel.onChange(this::change);
    }

    /** Both views call this for each other; the calls end when nothing changes. */
    private static void follow(WorldPanel view, WorldPanel leader) {
        boolean isSame = leader.orbit() == null
                || leader.orbit().equals(view.orbit()) && leader.cut().equals(view.cut());
        if (!isSame) {
            view.move(leader.orbit(), leader.cut());
        }
    }

    private void viewChanged() {
        if (viewed.isPresent()) {
            follow(other, site.world());
            // The coverage is that of the sensors of the run that is shown.
            other.setStyle(site.world().style().withSkin(Optional.empty()));
        }
    }

    /** Offers runs that were recorded before, and compares with the last one. */
    void compareWith(List<OtherRun> runs) {
        kept.addAll(runs);
        panel.offer(List.copyOf(kept));
        runs.stream().reduce((first, second) -> second).ifPresent(panel::choose);
    }

    /** Compares with the first run of a recording as soon as it has begun, and shows it beside this one. */
    void await(String name, Recording recording) {
        awaited = Optional.of(new Awaited(name, recording));
    }

    /** The runs that were offered other than those of the same sweep. */
    List<OtherRun> kept() {
        return List.copyOf(kept);
    }

    /** Shows the other run beside this one, or hides it. */
    void toggle() {
        if (panel.offered().isEmpty()) {
            messages.accept("There is no other run yet: the Compare tab explains how to create one");
            return;
        }
        if (panel.chosen().isEmpty()) {
            panel.choose(panel.offered().get(0));
            panel.setBeside(true);
        } else {
            panel.setBeside(!panel.isBeside());
        }
    }

    /**
     * Takes the runs that have been recorded, and compares them at a given time, s.
     *
     * @return whether the other run goes on, so that its site is to be drawn anew
     */
    boolean update(RecordedRun shown, List<RecordedRun> sweep, double now) {
        Optional<Awaited> begun =
                awaited.filter(next -> !next.recording().runs().isEmpty());
        begun.ifPresent(next -> {
            awaited = Optional.empty();
            compareWith(
                    List.of(new OtherRun(next.name(), next.recording().runs().get(0))));
            panel.setBeside(true);
        });
        List<OtherRun> offered = new ArrayList<>(kept);
        sweep.stream()
                .filter(run -> run != shown)
                .map(run -> new OtherRun(ControlBar.name(run), run))
                .forEach(offered::add);
        panel.offer(offered);
        panel.show(shown, now);
        double before = reached;
        reached = viewed.map(run -> run.run().reached()).orElse(0.0);
        return reached != before;
    }

    /** Shows the other site at a given time, s, as far as the other run has been simulated. */
    void showTime(double now, Optional<String> chosen) {
        time = now;
        selected = chosen;
        viewed.ifPresent(run -> other.show(run.state(Math.min(time, run.run().reached()), selected, Optional.empty())));
    }

    private void change() {
        Optional<OtherRun> wanted = panel.isBeside() ? panel.chosen() : Optional.empty();
        if (wanted.equals(asked)) {
            return;
        }
        asked = wanted;
        if (wanted.isEmpty()) {
            viewed = Optional.empty();
            site.showBeside(Optional.empty());
            return;
        }
        OtherRun next = wanted.get();
        preparing.ask(outdated -> {
            ViewedRun ready = new ViewedRun("other run: " + next.name(), next.run());
            SwingUtilities.invokeLater(() -> {
                if (asked.equals(wanted)) {
                    show(ready);
                }
            });
        });
    }

    private void show(ViewedRun ready) {
        viewed = Optional.of(ready);
        site.showBeside(Optional.of(other));
        WorldPanel own = site.world();
        other.show(ready.picture(), own.orbit(), own.cut());
        other.setStyle(own.style().withSkin(Optional.empty()));
        showTime(time, selected);
        messages.accept("On the right: " + ready.title() + "; same time, same viewpoint; B hides it");
    }

    /** The other site. */
    WorldPanel other() {
        return other;
    }

    /** The run whose site is shown beside this one. */
    Optional<ViewedRun> viewed() {
        return viewed;
    }

    /** Whether everything that was requested is drawn. */
    boolean isIdle() {
        return preparing.isIdle() && asked.isPresent() == viewed.isPresent() && other.isIdle();
    }

    /** Ends all threads. */
    void close() {
        preparing.close();
        other.close();
    }
}
