// Uses all of the package's types, for the TypeScript compiler only.
import { Idiophone, type InstrumentInfo, type ParameterInfo, type PlaceMetres } from "idiophone";

export async function play(file: Blob): Promise<number> {
    const context = new AudioContext();
    const idiophone: Idiophone = await Idiophone.start(context, { destination: context.createGain() });
    const names: string[] = idiophone.presets.map(({ name, tags }) => name + tags.length);
    const marimba: InstrumentInfo = await idiophone.loadPreset(names[0] ?? "Marimba");
    const level: ParameterInfo | undefined = idiophone.parameters.find(({ id }) => id === "level");
    idiophone.set("level", (level?.minimum ?? 0) + idiophone.get("level"));
    idiophone.noteOn(marimba.lowestNote, 100, context.currentTime + 0.1);
    idiophone.noteOff(marimba.notes[0]!.note);
    idiophone.send([0xb0, 64, 127]);
    await idiophone.loadObject(await file.arrayBuffer(), "bowl.glb");
    const place: PlaceMetres = marimba.objects[0]!.struckPlaces[0] ?? [0, 0, 0];
    idiophone.strike(0, place, 64);
    idiophone.scrape(0, place, 0.5);
    idiophone.onposes = poses => console.log(poses.length / 8);
    const { vertices, faces } = idiophone.mesh(0);
    await idiophone.settled();
    const { share } = await idiophone.cpuReport();
    idiophone.silence();
    idiophone.stop();
    idiophone.node.connect(context.destination);
    // @ts-expect-error: only `start` makes instruments
    new Idiophone();
    return share + vertices.length + faces.length + (idiophone.instrument?.bodies.length ?? 0);
}
