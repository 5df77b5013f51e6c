/**
 * The description of what to run: the tree of settings, overrides, sweeps, and warnings about settings that do not fit
 * together.
 */
package org.dronewatch.scenario;
