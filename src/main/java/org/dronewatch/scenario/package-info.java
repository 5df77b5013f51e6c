/** What to run: the tree of settings, overrides, sweeps, and advice on settings that do not fit together. */
package org.dronewatch.scenario;
