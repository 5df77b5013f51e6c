package org.dronewatch.placement.plan;

import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.dronewatch.world.World;

/** Warns of candidates whose sensors would detect nothing because of their positions. */
public record CandidateAdvice(PlacePlan plan, World world) {
    private static final int NAMED = 3;

    /** Gives one line if any candidates are inside walls or under the ground; sensors of the scene do not count. */
    public void giveTo(Consumer<String> target) {
        List<String> inside = plan.candidates().stream()
                .filter(one -> !plan.present().enabledSensors().containsKey(one.name()))
                .filter(one -> world.isInsideWall(one.sensor().position()))
                .map(SiteCandidate::name)
                .toList();
        if (inside.isEmpty()) {
            return;
        }
        boolean isOne = inside.size() == 1;
        String names = inside.stream().limit(NAMED).collect(Collectors.joining("', '", "'", "'"));
        String more = inside.size() > NAMED ? " and " + (inside.size() - NAMED) + " more" : "";
        target.accept((isOne ? "candidate " : "candidates ") + names + more
                + (isOne ? " seems" : " seem") + " to be inside a wall or under the ground: most surfaces around "
                + (isOne ? "it face away from it" : "them face away from them"));
    }
}
