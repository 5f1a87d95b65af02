using System.Collections.Generic;

namespace Rabit.Latency.Measuring;

/// <summary>
/// Measures several subjects in interleaved rounds, so that what the machine does at the time meets all of them alike.
/// </summary>
internal static class Rounds
{
    public static void Run(IReadOnlyList<Subject> subjects, int rounds, int warmUps = 1)
    {
        for (int i = 0; i < warmUps; i++)
        {
            foreach (Subject subject in subjects)
                subject.WarmUp();
        }

        for (int round = 0; round < rounds; round++)
        {
            // Another one begins in each round: none has always the same neighbour in front.
            for (int i = 0; i < subjects.Count; i++)
                subjects[(i + round) % subjects.Count].Measure();
        }
    }
}
