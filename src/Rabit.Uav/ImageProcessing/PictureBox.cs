namespace Rabit.Uav.ImageProcessing;

/// <summary>Where in a picture a report is, in parts of its width and height. A plain value.</summary>
/// <param name="ReportIndex">As <see cref="Messages.TargetReport.Index"/>.</param>
/// <param name="Left">0 at the left border, 1 at the right one.</param>
/// <param name="Top">0 at the upper border, 1 at the lower one.</param>
/// <param name="Width">1 is the whole width.</param>
/// <param name="Height">1 is the whole height.</param>
public readonly record struct PictureBox(int ReportIndex, double Left, double Top, double Width, double Height);
