using System;

namespace Rabit.Uav.ImageProcessing;

/// <summary>Keeps detections in the order that a detector owes: the most confident first.</summary>
internal static class DetectionOrder
{
    /// <summary>Inserts one; of equal ones, the one that was found first comes first. The last makes room.</summary>
    public static void Insert(
        in TargetDetection detection, Span<TargetDetection> detections, ref int count, ref int dropped)
    {
        int place = count;
        while (place > 0 && detections[place - 1].Score < detection.Score)
            place--;
        if (count == detections.Length)
            dropped++;
        else
            count++;
        if (place >= count)
            return;
        for (int i = count - 1; i > place; i--)
            detections[i] = detections[i - 1];
        detections[place] = detection;
    }
}
