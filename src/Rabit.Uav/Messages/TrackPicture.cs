namespace Rabit.Uav.Messages;

/// <summary>A report in a picture of our own camera that shows the target of a track. A plain value.</summary>
/// <param name="PictureNumber">As <see cref="TargetReport.PictureNumber"/>.</param>
/// <param name="ReportIndex">As <see cref="TargetReport.Index"/>.</param>
public readonly record struct TrackPicture(long PictureNumber, int ReportIndex);
