using System;
using System.Collections.Generic;
using System.Globalization;
using Rabit.Vision.Speed;

// --limits: what has a limit of its own, in some 10 s; exit code 1 where one is not kept. Else:
// How long a detector takes for a picture, for eng/vision-speed.py, which measures OpenCV in turn with it. Each line of
// the input, "OPERATION FOLDER REPEATS", is one pass over the pictures of a set; the answer is milliseconds a picture,
// bytes allocated a picture, and how much was found.
if (args.Length == 1 && args[0] == "--limits")
    return Limits.Check(Console.Out) ? 0 : 1;
var sets = new Dictionary<string, LoadedSet>(StringComparer.Ordinal);
while (Console.ReadLine() is { Length: > 0 } line)
{
    string[] words = line.Split(' ');
    if (!sets.TryGetValue(words[1], out LoadedSet? set))
        sets.Add(words[1], set = new LoadedSet(words[1]));
    PassResult result = set.Search(words[0], int.Parse(words[2], CultureInfo.InvariantCulture));
    Console.WriteLine(FormattableString.Invariant(
        $"{result.Milliseconds:0.00000} {result.AllocatedBytes:0.##} {result.Found}"));
}

return 0;
