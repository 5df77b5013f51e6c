package org.dronewatch.route.search;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.geometry.Position;

/**
 * Flies pieces of a path faster until it is short enough: always the piece on which a second that is gained costs the
 * least exposure. The course stays the same. For a single use; not thread-safe.
 */
final class Hastening {
    /** How much more than asked for is gained, so that rounding does not leave the path too long, s. */
    private static final double MORE = 1e-6;

    private final RouteProblem problem;
    private final RouteExposure exposure;
    private final List<Piece> pieces = new ArrayList<>();

    private Hastening(RouteProblem problem, RoutePath path) {
        this.problem = problem;
        this.exposure = new RouteExposure(problem);
        for (int leg = 0; leg < path.modes().size(); leg++) {
            Position from = path.points().get(leg);
            Position to = path.points().get(leg + 1);
            int count = Math.max(
                    1, (int) Math.ceil(from.distance(to) / problem.grid().spacing()));
            for (int i = 0; i < count; i++) {
                pieces.add(new Piece(
                        leg, (double) i / count, (i + 1.0) / count, path.modes().get(leg)));
            }
        }
    }

    /**
     * A path along the same course that takes less time.
     *
     * @param gain how much less, above 0, s
     * @return the path; as fast as the modes allow if that does not gain as much
     */
    static RoutePath of(RouteProblem problem, RoutePath path, double gain) {
        Hastening hastening = new Hastening(problem, path);
        hastening.gain(path, gain + MORE);
        return hastening.path(path);
    }

    /**
     * A piece of a leg.
     *
     * @param leg number of the leg
     * @param begin where the piece begins, as a fraction of the leg
     * @param end where it ends
     * @param mode number of the mode in which it is flown
     */
    private record Piece(int leg, double begin, double end, int mode) {
        Piece in(int other) {
            return new Piece(leg, begin, end, other);
        }

        Position from(RoutePath path) {
            return at(path, begin);
        }

        Position to(RoutePath path) {
            return at(path, end);
        }

        private Position at(RoutePath path, double share) {
            Position from = path.points().get(leg);
            Position to = path.points().get(leg + 1);
            return share == 1.0 ? to : from.plus(to.minus(from).times(share));
        }
    }

    /**
     * A piece flown in a faster mode.
     *
     * @param piece number of the piece
     * @param mode number of the mode
     * @param seconds how much time it gains, s
     * @param price what each second costs, 1/s
     */
    private record Change(int piece, int mode, double seconds, double price) {}

    private void gain(RoutePath path, double gain) {
        List<List<Change>> changes = new ArrayList<>();
        for (int i = 0; i < pieces.size(); i++) {
            changes.add(changes(path, i));
        }
        double left = gain;
        while (left > 0.0) {
            Change best = null;
            for (List<Change> ofPiece : changes) {
                for (Change change : ofPiece) {
                    best = best == null || change.price() < best.price() ? change : best;
                }
            }
            if (best == null) {
                return;
            }
            int number = best.piece();
            Piece piece = pieces.get(number);
            if (best.seconds() > left) {
                double middle = piece.begin() + left / best.seconds() * (piece.end() - piece.begin());
                pieces.set(number, new Piece(piece.leg(), piece.begin(), middle, best.mode()));
                pieces.add(number + 1, new Piece(piece.leg(), middle, piece.end(), piece.mode()));
                return;
            }
            left -= best.seconds();
            pieces.set(number, piece.in(best.mode()));
            changes.set(number, changes(path, number));
        }
    }

    /** The faster modes in which a piece may be flown. */
    private List<Change> changes(RoutePath path, int number) {
        Piece piece = pieces.get(number);
        Position from = piece.from(path);
        Position to = piece.to(path);
        double seconds = exposure.time(from, to, piece.mode());
        double cost = exposure.leg(from, to, piece.mode());
        List<Change> changes = new ArrayList<>();
        for (int mode = 0; mode < problem.modes().size(); mode++) {
            double gained = seconds - exposure.time(from, to, mode);
            if (problem.isExchangeable(piece.mode(), mode) && gained > 0.0) {
                changes.add(new Change(number, mode, gained, (exposure.leg(from, to, mode) - cost) / gained));
            }
        }
        return changes;
    }

    /** The path of all pieces; those of a leg that are flown in one mode become one leg again. */
    private RoutePath path(RoutePath path) {
        List<Position> points = new ArrayList<>(List.of(path.points().get(0)));
        List<Integer> modes = new ArrayList<>();
        for (int i = 0; i < pieces.size(); i++) {
            Piece piece = pieces.get(i);
            Piece next = i + 1 < pieces.size() ? pieces.get(i + 1) : null;
            if (next == null || next.leg() != piece.leg() || next.mode() != piece.mode()) {
                points.add(piece.to(path));
                modes.add(piece.mode());
            }
        }
        return new RoutePath(points, modes);
    }
}
