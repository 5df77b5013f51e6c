package org.dronewatch.tracking;

import java.util.List;

/**
 * Matches confirmed contacts of different sensors: decides which of them are one object, for rules that require several
 * sensors. It is a part of the association, and returns nothing but other contacts, so the caller does not learn what
 * caused them. Not thread-safe.
 */
public interface ContactMatcher {
    /** Matches no contacts, for rules that one sensor can meet. */
    ContactMatcher NONE = new ContactMatcher() {
        @Override
        public void confirm(ConfirmedContact confirmed) {}

        @Override
        public List<ConfirmedContact> others(ConfirmedContact confirmed) {
            return List.of();
        }

        @Override
        public void remove(int contact) {}

        @Override
        public int size() {
            return 0;
        }
    };

    /** Creates matchers; an association implements it. */
    @FunctionalInterface
    interface Source {
        /**
         * A matcher without contacts.
         *
         * @param gate maximum difference between the bearings of two contacts that may be one object, 0 to pi, rad
         * @param within maximum time between the confirmations of the two, 0 or more, s
         */
        ContactMatcher matcher(double gate, double within);
    }

    /** Records that a contact is confirmed at the present look of its sensor. */
    void confirm(ConfirmedContact confirmed);

    /**
     * The contacts of other sensors that are the same object as a contact, in the order of their confirmation; at most
     * one of each sensor. If measurements of one object by several sensors already share a contact number, the result
     * is empty.
     *
     * @param confirmed a contact that has been confirmed at the present look of its sensor
     */
    List<ConfirmedContact> others(ConfirmedContact confirmed);

    /** Removes a contact, which matches no other from then on. */
    void remove(int contact);

    /** The number of contacts that this matcher remembers at present. */
    int size();
}
