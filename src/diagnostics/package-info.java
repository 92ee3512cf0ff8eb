/** What is wrong with a file, and where: the problems that the readers of scenes and meshes report. */
package diagnostics;
