using System.Collections.Generic;
using Rabit.Mavlink;

namespace Rabit.Uav.Tests.ImageProcessing.Calibration;

/// <summary>Gives a filter the recorded answers and the times of the telemetry, each when it came in.</summary>
internal sealed class SequenceClock
{
    private readonly double[][] _answers = RecordedSequence.Rows("timesync.csv");
    private readonly double[][] _telemetry = RecordedSequence.Rows("telemetry.csv");
    private int _answer;
    private int _row;

    public MavlinkTimesyncFilter Filter { get; } = new();

    /// <summary>
    /// Everything that came before a time; but at least as many answers as a clock needs to be known.
    /// </summary>
    /// <returns>The rows of telemetry.</returns>
    public IEnumerable<double[]> RunTo(double untilMicroseconds)
    {
        while (_answer < MavlinkTimesyncFilter.MinAnswers && _answer < _answers.Length)
            TakeAnswer();
        while (true)
        {
            double answerAt = _answer < _answers.Length ? _answers[_answer][3] : double.MaxValue;
            double rowAt = _row < _telemetry.Length ? _telemetry[_row][1] : double.MaxValue;
            if (answerAt >= untilMicroseconds && rowAt >= untilMicroseconds)
                yield break;
            if (answerAt <= rowAt)
            {
                TakeAnswer();
                continue;
            }

            double[] row = _telemetry[_row++];
            Filter.AddOneWay(RecordedSequence.Microseconds(row[1]), row[0] * 1e-6);
            yield return row;
        }
    }

    private void TakeAnswer()
    {
        double[] row = _answers[_answer++];
        Filter.AddRoundTrip(
            RecordedSequence.Microseconds(row[1]), RecordedSequence.Microseconds(row[3]), row[2] * 1e-6);
    }
}
